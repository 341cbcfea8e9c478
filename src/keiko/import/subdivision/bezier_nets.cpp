#include "keiko/geometry/bernstein/binomial.h"
#include "keiko/geometry/bernstein/de_casteljau.h"
#include "keiko/import/subdivision/limit_patches.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <utility>

namespace keiko::subdivision {
namespace {

/// Four control points across the patch for each of the four along it.
using Row = std::array<Vec3, 4>;
using Rows = std::array<Row, 4>;

constexpr std::size_t at(std::size_t outer, std::size_t inner) {
    return outer * 4 + inner;
}

Row combine(const Row& a, double wa, const Row& b, double wb) {
    Row sum;
    for (std::size_t k = 0; k < 4; ++k) sum[k] = a[k] * wa + b[k] * wb;
    return sum;
}

/// The vertex rule of cubic splines.
Row smoothed(const Row& before, const Row& row, const Row& after) {
    Row sum;
    for (std::size_t k = 0; k < 4; ++k) sum[k] = (before[k] + row[k] * 6 + after[k]) / 8;
    return sum;
}

/// Uniform cubic B-spline to Bezier, for four points `step` apart.
void to_bezier(Vec3* p, std::size_t step) {
    const Vec3 a = p[0], b = p[step], c = p[2 * step], d = p[3 * step];
    p[0] = (a + b * 4 + c) / 6;
    p[step] = (b * 2 + c) / 3;
    p[2 * step] = (b + c * 2) / 3;
    p[3 * step] = (b + c * 4 + d) / 6;
}

BezierNet to_bezier(const SplineNet& net) {
    BezierNet result;
    for (std::size_t v = 0; v < 4; ++v)
        for (std::size_t u = 0; u < 4; ++u) result[at(u, v)] = net[at(v, u)];
    for (std::size_t k = 0; k < 4; ++k) to_bezier(&result[4 * k], 1);
    for (std::size_t k = 0; k < 4; ++k) to_bezier(&result[k], 4);
    return result;
}

/// A net seen from its crease: rows run along it, the second lies on it.
struct CreaseFrame {
    bool across_u; ///< rows lie across u
    bool backward; ///< the crease is the side of parameter 1

    explicit CreaseFrame(SideMask crease)
        : across_u(crease == 2 || crease == 8), backward(crease == 2 || crease == 4) {}

    std::size_t index(std::size_t row, std::size_t k) const {
        const std::size_t r = backward ? 3 - row : row;
        return across_u ? at(k, r) : at(r, k);
    }
    Rows rows(const SplineNet& net) const {
        Rows result;
        for (std::size_t r = 0; r < 4; ++r)
            for (std::size_t k = 0; k < 4; ++k) result[r][k] = net[index(r, k)];
        return result;
    }
    SplineNet net(const Rows& rows) const {
        SplineNet result;
        for (std::size_t r = 0; r < 4; ++r)
            for (std::size_t k = 0; k < 4; ++k) result[index(r, k)] = rows[r][k];
        return result;
    }
    /// The strip from `begin` to `end` away from the crease.
    Box2 box(double begin, double end) const {
        Box2 result{Vec2(0), Vec2(1)};
        const unsigned axis = across_u ? 0 : 1;
        result.lower[axis] = backward ? 1 - end : begin;
        result.upper[axis] = backward ? 1 - begin : end;
        return result;
    }
};

/// One subdivision step across the crease: the rows 0..4 around it at half the distance, row 1
/// being `on_crease`.
std::array<Row, 5> subdivided(const Rows& r, const Row& on_crease) {
    return {combine(r[0], 0.5, r[1], 0.5), on_crease, combine(r[1], 0.5, r[2], 0.5),
            smoothed(r[1], r[2], r[3]), combine(r[2], 0.5, r[3], 0.5)};
}

/// The infinitely sharp Bezier patch cut down to [begin, 1] away from the crease.
BezierNet cut(const BezierNet& whole, const CreaseFrame& frame, double begin) {
    BezierNet result;
    for (std::size_t k = 0; k < 4; ++k) {
        const auto index = [&](std::size_t row) {
            const std::size_t r = frame.backward ? 3 - row : row;
            return frame.across_u ? at(r, k) : at(k, r);
        };
        const std::array<Vec3, 4> row{whole[index(0)], whole[index(1)], whole[index(2)],
                                      whole[index(3)]};
        const std::array<Vec3, 4> beyond = bernstein_parts(row, begin)[1];
        for (std::size_t i = 0; i < 4; ++i) result[index(i)] = beyond[i];
    }
    return result;
}

// Newton's form on a uniform lattice: with n = degree and forward differences D[a][b] at the
// origin, the polynomial is the sum of D[a][b] C(n u, a) C(n v, b), C being binomials.

constexpr int most = 4;
using Matrix = std::array<std::array<double, most + 1>, most + 1>;
using Samples = std::array<std::array<Vec3, most + 1>, most + 1>;

/// matrix[a][i]: Bernstein coefficient i of C(n u, a).
Matrix bernstein_of_newton(int n) {
    Matrix result{};
    std::array<double, most + 1> monomials{1};
    const std::vector<double> of_n = binomials(static_cast<std::size_t>(n));
    for (int a = 0; a <= n; ++a) {
        for (int i = 0; i <= n; ++i) {
            const std::vector<double> of_i = binomials(static_cast<std::size_t>(i));
            for (int k = 0; k <= i; ++k) result[a][i] += monomials[k] * of_i[k] / of_n[k];
        }
        // C(n u, a + 1) = C(n u, a) (n u - a) / (a + 1)
        for (int k = n; k >= 0; --k)
            monomials[k] = ((k > 0 ? n * monomials[k - 1] : 0) - a * monomials[k]) / (a + 1);
    }
    return result;
}

/// Forward differences of samples (i, j) with i, j <= n and i + j <= total, in place.
void difference(Samples& s, int n, int total) {
    for (int level = 1; level <= n; ++level)
        for (int i = n; i >= level; --i)
            for (int j = 0; j <= std::min(n, total - i); ++j) s[i][j] -= s[i - 1][j];
    for (int level = 1; level <= n; ++level)
        for (int j = n; j >= level; --j)
            for (int i = 0; i <= std::min(n, total - j); ++i) s[i][j] -= s[i][j - 1];
}

Samples differences(int n, int total, const SurfaceSample& surface) {
    Samples samples;
    for (auto& row : samples) row.fill(Vec3(0));
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= std::min(n, total - i); ++j)
            samples[i][j] = surface(double(i) / n, double(j) / n);
    difference(samples, n, total);
    return samples;
}

} // namespace

BezierNet bezier_of_spline(SplineNet net, SideMask borders) {
    const auto mirror = [&](std::size_t out, std::size_t on, std::size_t in, std::size_t step) {
        for (std::size_t k = 0; k < 4; ++k)
            net[out + k * step] = net[on + k * step] * 2 - net[in + k * step];
    };
    if (borders & 1) mirror(at(0, 0), at(1, 0), at(2, 0), 1);
    if (borders & 4) mirror(at(3, 0), at(2, 0), at(1, 0), 1);
    if (borders & 8) mirror(at(0, 0), at(0, 1), at(0, 2), 4);
    if (borders & 2) mirror(at(0, 3), at(0, 2), at(0, 1), 4);
    return to_bezier(net);
}

std::vector<SplinePiece> pieces_beside_crease(const SplineNet& net, SideMask crease,
                                              double sharpness) {
    const CreaseFrame frame(crease);
    const int sharp_levels = static_cast<int>(std::floor(sharpness));
    const double fraction = sharpness - sharp_levels;
    std::vector<SplinePiece> pieces;
    Rows rows = frame.rows(net);
    double width = 1;
    for (int level = 0; level < sharp_levels; ++level, width /= 2) {
        const std::array<Row, 5> next = subdivided(rows, rows[1]);
        rows = {next[0], next[1], next[2], next[3]};
    }
    if (sharp_levels > 0)
        pieces.push_back({frame.box(width, 1), cut(bezier_of_spline(net, crease), frame, width)});
    if (fraction > 0) {
        const Row smooth = smoothed(rows[0], rows[1], rows[2]);
        const std::array<Row, 5> next =
            subdivided(rows, combine(rows[1], fraction, smooth, 1 - fraction));
        pieces.push_back({frame.box(width / 2, width),
                          to_bezier(frame.net({next[1], next[2], next[3], next[4]}))});
        rows = {next[0], next[1], next[2], next[3]};
        width /= 2;
    }
    pieces.push_back({frame.box(0, width), to_bezier(frame.net(rows))});
    return pieces;
}

std::vector<Vec3> fit_square(int n, const SurfaceSample& surface) {
    assert(n <= most);
    const Samples samples = differences(n, 2 * n, surface);
    const Matrix matrix = bernstein_of_newton(n);
    std::vector<Vec3> points;
    for (int i = 0; i <= n; ++i)
        for (int j = 0; j <= n; ++j) {
            Vec3 sum(0);
            for (int a = 0; a <= n; ++a)
                for (int b = 0; b <= n; ++b) sum += samples[a][b] * (matrix[a][i] * matrix[b][j]);
            points.push_back(sum);
        }
    return points;
}

SurfaceSample triangle_polynomial(const SurfaceSample& surface) {
    constexpr int n = 4;
    return [samples = differences(n, n, surface)](double u, double v) {
        std::array<double, n + 1> at_u{1}, at_v{1};
        for (int k = 0; k < n; ++k) {
            at_u[k + 1] = at_u[k] * (n * u - k) / (k + 1);
            at_v[k + 1] = at_v[k] * (n * v - k) / (k + 1);
        }
        Vec3 sum(0);
        for (int a = 0; a <= n; ++a)
            for (int b = 0; a + b <= n; ++b) sum += samples[a][b] * (at_u[a] * at_v[b]);
        return sum;
    };
}

} // namespace keiko::subdivision
