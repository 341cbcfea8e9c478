#include "keiko/visibility/nets/tangent_planes.h"

#include "keiko/geometry/bernstein/binomial.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// A polynomial of two variables by its scaled Bernstein coefficients, c_ij C(m, i) C(n, j): a
/// product is then a plain convolution [FaroukiRajan1988].
struct Scaled {
    std::size_t rows = 0, columns = 0;
    std::vector<double> c;

    Scaled(std::size_t r, std::size_t k) : rows(r), columns(k), c(r * k, 0.0) {}
    double& at(std::size_t i, std::size_t j) { return c[i * columns + j]; }
    double at(std::size_t i, std::size_t j) const { return c[i * columns + j]; }
};

Scaled operator*(const Scaled& a, const Scaled& b) {
    Scaled product(a.rows + b.rows - 1, a.columns + b.columns - 1);
    for (std::size_t i = 0; i < a.rows; ++i)
        for (std::size_t j = 0; j < a.columns; ++j)
            for (std::size_t k = 0; k < b.rows; ++k)
                for (std::size_t l = 0; l < b.columns; ++l)
                    product.at(i + k, j + l) += a.at(i, j) * b.at(k, l);
    return product;
}

Scaled& operator+=(Scaled& a, const Scaled& b) {
    for (std::size_t i = 0; i < a.c.size(); ++i) a.c[i] += b.c[i];
    return a;
}

Scaled& operator-=(Scaled& a, const Scaled& b) {
    for (std::size_t i = 0; i < a.c.size(); ++i) a.c[i] -= b.c[i];
    return a;
}

/// Component `k` of a net.
Scaled scaled(const HomogeneousNet& net, unsigned k) {
    const auto m = static_cast<std::size_t>(net.degree_u),
               n = static_cast<std::size_t>(net.degree_v);
    Scaled s(m + 1, n + 1);
    const std::vector<double> by_u = binomials(m), by_v = binomials(n);
    for (std::size_t i = 0; i <= m; ++i)
        for (std::size_t j = 0; j <= n; ++j)
            s.at(i, j) = net.points[i * (n + 1) + j][k] * by_u[i] * by_v[j];
    return s;
}

HomogeneousNet derivative(const BezierPatchView& patch, bool by_u) {
    HomogeneousNet d{patch.degree_u - by_u, patch.degree_v - !by_u, {}};
    const double degree = by_u ? patch.degree_u : patch.degree_v;
    for (int i = 0; i <= d.degree_u; ++i)
        for (int j = 0; j <= d.degree_v; ++j)
            d.points.push_back((patch.point(i + by_u, j + !by_u) - patch.point(i, j)) * degree);
    return d;
}

using Scaled3 = std::array<Scaled, 3>;

Scaled3 spatial(const HomogeneousNet& net) {
    return {scaled(net, 0), scaled(net, 1), scaled(net, 2)};
}

Scaled3 cross(const Scaled3& a, const Scaled3& b) {
    const auto component = [&](std::size_t i, std::size_t j) {
        Scaled s = a[i] * b[j];
        s -= a[j] * b[i];
        return s;
    };
    return {component(1, 2), component(2, 0), component(0, 1)};
}

double largest(const HomogeneousNet& net) {
    double most = 0;
    for (const Vec4& p : net.points)
        for (unsigned k = 0; k < 4; ++k) most = std::max(most, std::abs(p[k]));
    return most;
}

/// Divides by the distance to one side, on which all coefficients are zero.
HomogeneousNet without_side(const HomogeneousNet& net, bool along_u, bool at_end) {
    HomogeneousNet less{net.degree_u - along_u, net.degree_v - !along_u, {}};
    const int degree = along_u ? net.degree_u : net.degree_v;
    for (int i = 0; i <= less.degree_u; ++i)
        for (int j = 0; j <= less.degree_v; ++j) {
            const int k = along_u ? i : j;
            const double factor = double(degree) / (at_end ? degree - k : k + 1);
            const int from_i = i + (along_u && !at_end), from_j = j + (!along_u && !at_end);
            less.points.push_back(net.view().point(from_i, from_j) * factor);
        }
    return less;
}

bool vanishes_on_side(const HomogeneousNet& net, bool along_u, bool at_end, double noise) {
    const int last = along_u ? net.degree_v : net.degree_u;
    for (int k = 0; k <= last; ++k) {
        const Vec4& p = along_u ? net.view().point(at_end ? net.degree_u : 0, k)
                                : net.view().point(k, at_end ? net.degree_v : 0);
        if (!(p.length() <= noise)) return false;
    }
    return true;
}

HomogeneousNet without_collapsed_sides(HomogeneousNet net) {
    constexpr double rounding = 1e-13;
    for (const bool along_u : {true, false})
        for (const bool at_end : {false, true})
            for (int k = 0; k < 2; ++k) {
                const double noise = rounding * largest(net);
                if ((along_u ? net.degree_u : net.degree_v) < 1 ||
                    !vanishes_on_side(net, along_u, at_end, noise))
                    break;
                net = without_side(net, along_u, at_end);
            }
    return net;
}

} // namespace

HomogeneousNet tangent_planes(const BezierPatchView& patch) {
    const HomogeneousNet whole{
        patch.degree_u, patch.degree_v, {patch.points.begin(), patch.points.end()}};
    const HomogeneousNet by_u = derivative(patch, true), by_v = derivative(patch, false);
    const Scaled3 h = spatial(whole), hu = spatial(by_u), hv = spatial(by_v);
    const Scaled w = scaled(whole, 3), wu = scaled(by_u, 3), wv = scaled(by_v, 3);
    const Scaled3 normal = cross(hu, hv);

    // w (h_u x h_v) + w_v (h x h_u) - w_u (h x h_v), and -h.(h_u x h_v)
    std::array<Scaled, 4> plane{w * normal[0], w * normal[1], w * normal[2], h[0] * normal[0]};
    if (patch.rational()) {
        const Scaled3 beside_u = cross(h, hu), beside_v = cross(h, hv);
        for (std::size_t k = 0; k < 3; ++k) {
            plane[k] += wv * beside_u[k];
            plane[k] -= wu * beside_v[k];
        }
    }
    plane[3] += h[1] * normal[1];
    plane[3] += h[2] * normal[2];

    const std::size_t rows = plane[0].rows, columns = plane[0].columns;
    const std::vector<double> of_u = binomials(rows - 1), of_v = binomials(columns - 1);
    HomogeneousNet net{static_cast<int>(rows) - 1, static_cast<int>(columns) - 1, {}};
    for (std::size_t i = 0; i < rows; ++i)
        for (std::size_t j = 0; j < columns; ++j) {
            const double scale = 1 / (of_u[i] * of_v[j]);
            net.points.push_back(
                Vec4(plane[0].at(i, j), plane[1].at(i, j), plane[2].at(i, j), -plane[3].at(i, j)) *
                scale);
        }
    return without_collapsed_sides(std::move(net));
}

bool is_flat(const HomogeneousNet& planes) {
    // Rounding of the products above.
    constexpr double noise = 1e-12;
    const Vec4 mean = [&] {
        Vec4 sum(0);
        for (const Vec4& p : planes.points) sum += p;
        return sum;
    }();
    if (!(mean.length() > 0)) return true;
    const Vec4 axis = mean / mean.length();
    const double most = largest(planes);
    return std::all_of(planes.points.begin(), planes.points.end(), [&](const Vec4& p) {
        return (p - axis * p.dot(axis)).length() <= noise * most;
    });
}

} // namespace keiko
