#include "keiko/intersect/subpatch/sub_patch_polynomial.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
constexpr double extended_epsilon =
    static_cast<double>(std::numeric_limits<long double>::epsilon());

/// power[k][i]: coefficient of x^k in the i-th Bernstein polynomial of u = (1 + x) / 2. Integers
/// over a power of two, exact in extended precision.
struct PowerBasis {
    std::array<std::array<long double, max_degree + 1>, max_degree + 1> power{};
    double magnitude = 0; ///< sum of all magnitudes

    explicit PowerBasis(int degree) {
        const auto n = static_cast<std::size_t>(degree);
        long double binomial = std::ldexp(1.0L, -degree);
        for (std::size_t i = 0; i <= n; ++i) {
            power[0][i] = binomial;
            for (std::size_t k = 0; k < n; ++k) multiply(i, k < i ? 1 : -1, k);
            binomial = binomial * static_cast<long double>(n - i) / static_cast<long double>(i + 1);
        }
        for (const auto& row : power)
            for (const long double c : row) magnitude += static_cast<double>(std::abs(c));
    }

private:
    /// Column i, of degree k, times (1 + sign x).
    void multiply(std::size_t i, int sign, std::size_t k) {
        for (std::size_t j = k + 1; j > 0; --j)
            power[j][i] += static_cast<long double>(sign) * power[j - 1][i];
    }
};

using Coefficients = std::vector<std::array<long double, 4>>;

/// Component k of a control point in the frame.
std::array<long double, 4> in_frame(const Vec4& p, const SubPatchFrame& frame) {
    const Vec3 moved = Vec3(p.x, p.y, p.z) - frame.center * p.w;
    std::array<long double, 4> c{};
    for (std::size_t k = 0; k < 3; ++k) c[k] = frame.weight_scale * frame.rows[k].dot(moved);
    c[3] = frame.weight_scale * p.w;
    return c;
}

/// Basis change along one parameter of a net of `lines` lines.
Coefficients changed(const Coefficients& net, const PowerBasis& basis, std::size_t count,
                     std::size_t step, std::size_t lines, std::size_t stride) {
    Coefficients result(net.size());
    for (std::size_t line = 0; line < lines; ++line)
        for (std::size_t k = 0; k < count; ++k)
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t c = 0; c < 4; ++c)
                    result[line * stride + k * step][c] +=
                        basis.power[k][i] * net[line * stride + i * step][c];
    return result;
}

/// Of each component.
std::array<double, 4> largest_magnitude(const Coefficients& net) {
    std::array<double, 4> largest{};
    for (const auto& p : net)
        for (std::size_t c = 0; c < 4; ++c)
            largest[c] = std::max(largest[c], static_cast<double>(std::abs(p[c])));
    return largest;
}

std::array<double, 4> rounded(const std::array<long double, 4>& from) {
    std::array<double, 4> to{};
    for (std::size_t c = 0; c < 4; ++c) to[c] = static_cast<double>(from[c]);
    return to;
}

/// Without weights the kernels take 1 for granted.
void set_weight_to_one(SubPatchPolynomial& polynomial) {
    for (auto& c : polynomial.coefficients) c[3] = 0;
    polynomial.coefficients.front()[3] = 1;
}

} // namespace

SubPatchPolynomial sub_patch_polynomial(const BezierPatchView& sub_patch,
                                        const SubPatchFrame& frame) {
    const auto rows = static_cast<std::size_t>(sub_patch.degree_u) + 1;
    const auto columns = static_cast<std::size_t>(sub_patch.degree_v) + 1;
    Coefficients net;
    for (const Vec4& p : sub_patch.points) net.push_back(in_frame(p, frame));
    const std::array<double, 4> largest = largest_magnitude(net);
    const PowerBasis u(sub_patch.degree_u), v(sub_patch.degree_v);
    net = changed(net, u, rows, columns, columns, 1);
    net = changed(net, v, columns, 1, rows, columns);

    SubPatchPolynomial polynomial;
    std::array<double, 4> sum{};
    for (const auto& coefficients : net) {
        polynomial.coefficients.push_back(rounded(coefficients));
        for (std::size_t c = 0; c < 4; ++c) sum[c] += std::abs(polynomial.coefficients.back()[c]);
    }
    if (!sub_patch.rational()) set_weight_to_one(polynomial);
    // The sums: one rounding a term. Horner: two a step, and one when a coefficient was stored.
    const double terms = static_cast<double>(rows + columns);
    for (std::size_t c = 0; c < 4; ++c)
        polynomial.rounding[c] = extended_epsilon * terms * u.magnitude * v.magnitude * largest[c] +
                                 epsilon * (2 * terms + 1) * sum[c];
    return polynomial;
}

} // namespace keiko
