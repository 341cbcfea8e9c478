#include "keiko/math/axes.h"

#include <Imath/ImathMatrix.h>
#include <Imath/ImathMatrixAlgo.h>

#include <algorithm>

namespace keiko {

void SecondMoments::add(const Vec3& v, double weight) {
    for (unsigned i = 0; i < 3; ++i) rows[i] += v * (weight * v[i]);
}

std::array<Vec3, 3> principal_axes(const SecondMoments& moments) {
    const auto& r = moments.rows;
    Imath::M33d matrix(r[0].x, r[0].y, r[0].z, r[1].x, r[1].y, r[1].z, r[2].x, r[2].y, r[2].z);
    Vec3 values(0);
    Imath::M33d vectors; // in its columns
    Imath::jacobiEigenSolver(matrix, values, vectors);
    std::array<unsigned, 3> order{0, 1, 2};
    std::stable_sort(order.begin(), order.end(),
                     [&](unsigned a, unsigned b) { return values[a] > values[b]; });
    const auto column = [&](unsigned i) {
        return Vec3(vectors[0][i], vectors[1][i], vectors[2][i]);
    };
    const Vec3 first = column(order[0]).normalized(), second = column(order[1]).normalized();
    return {first, second, first.cross(second)};
}

} // namespace keiko
