#include "keiko/intersect/subpatch/sub_patch_frame.h"

#include "keiko/geometry/bernstein/bernstein_field.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {

namespace {

/// Component net of `sub-patch` in a frame: 0, 1, 2 for w X, w Y, w Z and 3 for w.
BernsteinNet component(const BezierPatchView& sub_patch, const SubPatchFrame& frame,
                       std::size_t which) {
    BernsteinNet net;
    net.rows = static_cast<std::size_t>(sub_patch.degree_u) + 1;
    net.columns = static_cast<std::size_t>(sub_patch.degree_v) + 1;
    for (std::size_t i = 0; i < sub_patch.points.size(); ++i) {
        const Vec4& p = sub_patch.points[i];
        const Vec3 moved = Vec3(p.x, p.y, p.z) - frame.center * p.w;
        net.c[i] = frame.weight_scale * (which == 3 ? p.w : frame.rows[which].dot(moved));
    }
    return net;
}

/// The component without its affine part.
NetBounds deviation(const BezierPatchView& sub_patch, const SubPatchFrame& frame,
                    std::size_t which) {
    BernsteinNet net = component(sub_patch, frame, which);
    for (std::size_t i = 0; i < net.rows; ++i)
        for (std::size_t j = 0; j < net.columns; ++j) {
            if (which == 0) net.at(i, j) -= 2.0 * static_cast<double>(i) / sub_patch.degree_u - 1;
            if (which == 1) net.at(i, j) -= 2.0 * static_cast<double>(j) / sub_patch.degree_v - 1;
            if (which == 3) net.at(i, j) -= 1;
        }
    return net_bounds(net);
}

ComponentBounds symmetric(const NetBounds& b) {
    return {std::max(std::abs(b.low), std::abs(b.high)), b.slope, b.bend};
}

double middle(const NetBounds& b) {
    return (b.low + b.high) / 2;
}

/// The plane of the mean tangents; its normal is as long as they are on the geometric mean.
SubPatchFrame mean_frame(const BezierPatchView& sub_patch) {
    const Vec3 a = euclidean(sub_patch.point(0, 0)),
               b = euclidean(sub_patch.point(sub_patch.degree_u, 0));
    const Vec3 c = euclidean(sub_patch.point(0, sub_patch.degree_v));
    const Vec3 d = euclidean(sub_patch.point(sub_patch.degree_u, sub_patch.degree_v));
    const Vec3 along_u = (b + d - a - c) / 4, along_v = (c + d - a - b) / 4;
    const Vec3 normal = along_u.cross(along_v);
    SubPatchFrame frame;
    frame.center = (a + b + c + d) / 4;
    frame.length = Vec2(along_u.length(), along_v.length()) * 2;
    const double area = normal.length(), product = along_u.length() * along_v.length();
    frame.regular = area > 1e-6 * product && std::isfinite(1 / (area * area));
    if (!frame.regular) return frame;
    const double area2 = area * area;
    frame.rows = {along_v.cross(normal) / area2, normal.cross(along_u) / area2,
                  normal / (area * std::sqrt(product))};
    return frame;
}

/// A net that is not near any plane: what halving it would do, from the points as they are.
void bends_of_points(const BezierPatchView& sub_patch, SubPatchFrame& frame) {
    SubPatchFrame plain;
    for (std::size_t k = 0; k < 3; ++k) {
        plain.rows[k][static_cast<unsigned>(k)] = 1;
        const NetBounds b = net_bounds(component(sub_patch, plain, k));
        frame.bend_u = std::max(frame.bend_u, b.bend_u);
        frame.bend_v = std::max(frame.bend_v, b.bend_v);
        frame.twist = std::max(frame.twist, b.twist);
    }
}

/// Moves the centre so that each component deviates as far to one side as to the other.
void balance(const BezierPatchView& sub_patch, SubPatchFrame& frame) {
    frame.weight_scale = 1 / middle(net_bounds(component(sub_patch, frame, 3)));
    Vec3 shift(0);
    for (std::size_t k = 0; k < 3; ++k)
        shift[static_cast<unsigned>(k)] = middle(deviation(sub_patch, frame, k));
    // The inverse of `rows`, by cofactors.
    const auto& r = frame.rows;
    const double determinant = r[0].dot(r[1].cross(r[2]));
    frame.center +=
        (r[1].cross(r[2]) * shift.x + r[2].cross(r[0]) * shift.y + r[0].cross(r[1]) * shift.z) /
        determinant;
}

/// Tangent of 60 degrees.
constexpr double steepest = 1.7320508075688772;
/// A ray that meets the sub-patch at all meets the frame's plane not much farther out than this.
constexpr double farthest = 1.25;

/// How strongly a ray 60 degrees off mixes the normal component into the others.
double mixing(const SubPatchFrame& frame, std::size_t which) {
    return steepest * frame.rows[which].length() / frame.rows[2].length();
}

} // namespace

double SubPatchFrame::contraction() const {
    if (!regular) return std::numeric_limits<double>::infinity();
    return std::max(u.slope + mixing(*this, 0) * n.slope, v.slope + mixing(*this, 1) * n.slope) +
           farthest * w.slope;
}

SubPatchFrame sub_patch_frame(const BezierPatchView& sub_patch) {
    SubPatchFrame frame = mean_frame(sub_patch);
    if (!frame.regular) {
        bends_of_points(sub_patch, frame);
        return frame;
    }
    balance(sub_patch, frame);
    const std::array<NetBounds, 4> b{deviation(sub_patch, frame, 0), deviation(sub_patch, frame, 1),
                                     deviation(sub_patch, frame, 2),
                                     deviation(sub_patch, frame, 3)};
    frame.u = symmetric(b[0]);
    frame.v = symmetric(b[1]);
    frame.n = symmetric(b[2]);
    frame.w = symmetric(b[3]);
    frame.regular = frame.w.value < 0.5;
    frame.height = frame.n.value / (1 - std::min(frame.w.value, 0.5));
    const double mix = std::max(mixing(frame, 0), mixing(frame, 1));
    const std::array<double, 4> say{1, 1, mix, farthest};
    for (std::size_t k = 0; k < 4; ++k) {
        frame.bend_u += say[k] * b[k].bend_u;
        frame.bend_v += say[k] * b[k].bend_v;
        frame.twist += say[k] * b[k].twist;
    }
    return frame;
}

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

/// Largest magnitude of each component.
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
