#include "keiko/visibility/silhouettes/chord_elevation.h"

#include "tests/support/random_patches.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>

using namespace keiko;

namespace {

double bernstein(int degree, int i, double t) {
    double value = 1;
    for (int k = 0; k < i; ++k) value *= t * (degree - k) / (k + 1.0);
    return value * std::pow(1 - t, degree - i);
}

/// Homogeneous.
Vec4 point(const HomogeneousNet& net, double u, double v) {
    Vec4 sum(0);
    for (int i = 0; i <= net.degree_u; ++i)
        for (int j = 0; j <= net.degree_v; ++j)
            sum += net.points[static_cast<std::size_t>(i * (net.degree_v + 1) + j)] *
                   (bernstein(net.degree_u, i, u) * bernstein(net.degree_v, j, v));
    return sum;
}

HomogeneousNet net_of(const test::PatchData& patch) {
    HomogeneousNet net;
    net.degree_u = patch.degree_u;
    net.degree_v = patch.degree_v;
    net.points.assign(patch.points.begin(), patch.points.end());
    return net;
}

void expect_within(const Vec4& derivative, const TangentBounds::Range& range) {
    for (unsigned k = 0; k < 4; ++k)
        EXPECT_LE(std::abs(derivative[k] - range.middle[k]), range.half[k] + 1e-5) << k;
}

/// The sine at which `from` sees `to` over the plane.
double elevation(const Vec4& from, const Vec4& to, const Vec3& normal) {
    const Vec3 way = Vec3(to.x, to.y, to.z) / to.w - Vec3(from.x, from.y, from.z) / from.w;
    return way.length() > 1e-6 ? std::abs(normal.dot(way)) / way.length() : 0;
}

} // namespace

TEST(TangentBounds, HoldTheDerivativesOfRationalPatches) {
    test::Random random(41);
    for (int i = 0; i < 100; ++i) {
        const int degree_u = 1 + static_cast<int>(test::pick(random, 4));
        const int degree_v = 1 + static_cast<int>(test::pick(random, 4));
        const HomogeneousNet net =
            net_of(test::random_patch(random, degree_u, degree_v, 20, i % 2 == 0 ? 1 : 4));
        const TangentBounds bounds = tangent_bounds(net);
        for (int k = 0; k < 40; ++k) {
            const double u = test::uniform(random, 0, 1), v = test::uniform(random, 0, 1);
            constexpr double h = 1e-4; // by differences between places in the patch
            const double u0 = std::min(u, 1 - h), v0 = std::min(v, 1 - h);
            expect_within((point(net, u0 + h, v) - point(net, u0, v)) / (h * degree_u),
                          bounds.along_u);
            expect_within((point(net, u, v0 + h) - point(net, u, v0)) / (h * degree_v),
                          bounds.along_v);
        }
    }
}

TEST(SteepestChord, IsAboveEveryChordOfThePatch) {
    test::Random random(42);
    int telling = 0;
    for (int i = 0; i < 300; ++i) {
        const HomogeneousNet net =
            net_of(test::random_patch(random, 3, 3, test::uniform(random, 0, 6), i % 2 ? 1 : 1.3));
        const Vec4 from = point(net, test::uniform(random, 0, 1), test::uniform(random, 0, 1));
        const Vec3 foot = Vec3(from.x, from.y, from.z) / from.w;
        const Vec3 normal = (Vec3(0, 0, 1) + test::random_direction(random) * 0.1).normalized();
        const double by_bounds = steepest_chord(tangent_bounds(net), foot, normal);
        const double by_net = steepest_chord(net, {Vec2(0), Vec2(1)}, foot, normal);
        double steepest = 0;
        for (int k = 0; k < 200; ++k)
            steepest = std::max(steepest, elevation(from,
                                                    point(net, test::uniform(random, 0, 1),
                                                          test::uniform(random, 0, 1)),
                                                    normal));
        EXPECT_GE(by_bounds, steepest);
        EXPECT_GE(by_net, steepest);
        telling += by_bounds < 0.9 && by_net < 0.9;
    }
    EXPECT_GT(telling, 80) << "bounds that say something";
}
