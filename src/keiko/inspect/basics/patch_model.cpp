#include "keiko/inspect/basics/patch_model.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {
namespace {

/// Ratio of the weights of neighbouring control points that makes a row run as fast at its end as
/// at its beginning; at most a factor of 4 over the whole row.
double evening_ratio(const BezierPatchView& patch, bool along_u) {
    const int degree = along_u ? patch.degree_u : patch.degree_v;
    const int rows = along_u ? patch.degree_v : patch.degree_u;
    const auto at = [&](int k, int row) {
        return along_u ? patch.point(k, row) : patch.point(row, k);
    };
    const auto speed = [&](const Vec4& end, const Vec4& next) {
        return (Vec3(next.x, next.y, next.z) - Vec3(end.x, end.y, end.z) * (next.w / end.w))
                   .length() /
               end.w;
    };
    double first = 0, last = 0;
    for (int row = 0; row <= rows; ++row) {
        first += speed(at(0, row), at(1, row));
        last += speed(at(degree, row), at(degree - 1, row));
    }
    const double most = std::pow(4.0, 1.0 / degree);
    if (!(first > 0 && last > 0)) return 1;
    return std::clamp(std::sqrt(last / first), 1 / most, most);
}

/// The patch reparametrised so that its parameters run more uniformly. Replacing u by r u / (1 + (r
/// - 1) u) keeps every point on the surface and multiplies control points by powers of r
/// [Patterson1985].
std::vector<Vec4> evened(const BezierPatchView& patch) {
    std::vector<Vec4> points(patch.points.begin(), patch.points.end());
    if (!patch.rational()) return points;
    const double ratio_u = evening_ratio(patch, true), ratio_v = evening_ratio(patch, false);
    std::size_t index = 0;
    double row = 1;
    for (int i = 0; i <= patch.degree_u; ++i, row *= ratio_u) {
        double factor = row;
        for (int j = 0; j <= patch.degree_v; ++j, factor *= ratio_v) points[index++] *= factor;
    }
    return points;
}

/// Moves a patch to its centre and turns it so that its tangents there lie in the plane z = 0. The
/// ranges of a small piece then depend on its curvature, not on its position and orientation in
/// space.
void level(const BezierPatchView& patch, std::vector<Vec4>& points) {
    const SurfaceDerivatives s = evaluate({patch.degree_u, patch.degree_v, points}, {0.5, 0.5}, 1);
    const Vec3 n = s.du().cross(s.dv());
    if (!(n.length() > 0)) return;
    const Vec3 x = s.du().normalized(), z = n.normalized(), y = z.cross(x);
    for (Vec4& p : points) {
        const Vec3 from_centre = Vec3(p.x, p.y, p.z) - s.position() * p.w;
        p = Vec4(from_centre.dot(x), from_centre.dot(y), from_centre.dot(z), p.w);
    }
}

/// Rounding error of the control points of a levelled patch, mm.
double rounding_of(const BezierPatchView& patch, const std::vector<Vec4>& points, double given) {
    constexpr double relative_rounding = 1e-14;
    double extent = 0, weight = 0, weight_before = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec4 &p = points[i], &q = patch.points[i];
        extent = std::max({extent, std::abs(p.x), std::abs(p.y), std::abs(p.z), std::abs(q.x),
                           std::abs(q.y), std::abs(q.z)});
        weight = std::max(weight, p.w), weight_before = std::max(weight_before, q.w);
    }
    const double growth = weight / weight_before;
    return (relative_rounding * extent + given) * std::max(1.0, growth);
}

/// Order of the models. One more is needed for their remainders, and two for the second
/// derivatives.
constexpr std::size_t order = 6;

/// 1 / (i! j!) of the terms x^i y^j, in the order of a model's coefficients, to degree 4.
constexpr std::array<double, 15> taylor_shares{1,        1,       1,       1.0 / 2, 1,
                                               1.0 / 2,  1.0 / 6, 1.0 / 2, 1.0 / 2, 1.0 / 6,
                                               1.0 / 24, 1.0 / 6, 1.0 / 4, 1.0 / 6, 1.0 / 24};

/// A derivative of point and weight: its value at the centre, and its largest size anywhere.
struct Derivative {
    Vec4 centre{0}, most{0};
    double growth = 0; ///< factor by which errors of control points are amplified in it
};

/// Control points of a derivative, u outer; none where it vanishes. x runs twice as far as u, which
/// halves each derivative.
struct Net {
    std::size_t rows = 0, columns = 0;
    std::vector<Vec4> points;

    void differentiate_by_x() {
        if (rows < 2 || points.empty()) return points.clear();
        const double half_degree = static_cast<double>(--rows) / 2;
        for (std::size_t i = 0; i < rows * columns; ++i)
            points[i] = (points[i + columns] - points[i]) * half_degree;
        points.resize(rows * columns);
    }
    void differentiate_by_y() {
        if (columns < 2 || points.empty()) return points.clear();
        const double half_degree = static_cast<double>(columns - 1) / 2;
        for (std::size_t i = 0; i < rows; ++i)
            for (std::size_t j = 0; j + 1 < columns; ++j)
                points[i * (columns - 1) + j] =
                    (points[i * columns + j + 1] - points[i * columns + j]) * half_degree;
        --columns;
        points.resize(rows * columns);
    }
    /// Largest coordinates of its control points, whose convex hull holds the derivative.
    Vec4 most() const {
        Vec4 largest(0);
        for (const Vec4& p : points)
            for (int axis = 0; axis < 4; ++axis)
                largest[axis] = std::max(largest[axis], std::abs(p[axis]));
        return largest;
    }
    Vec4 centre() const {
        const CentralShares &by_row = central_shares()[rows],
                            &by_column = central_shares()[columns];
        Vec4 sum(0);
        for (std::size_t i = 0; i < rows; ++i) {
            Vec4 row(0);
            for (std::size_t j = 0; j < columns; ++j) row += points[i * columns + j] * by_column[j];
            sum += row * by_row[i];
        }
        return sum;
    }

private:
    using CentralShares = std::array<double, max_degree + 1>;

    /// The Bernstein polynomials at 1/2, by their number.
    static const std::array<CentralShares, max_degree + 2>& central_shares() {
        static const auto table = [] {
            std::array<CentralShares, max_degree + 2> shares{};
            for (std::size_t count = 1; count < shares.size(); ++count) {
                shares[count][0] = std::ldexp(1.0, 1 - static_cast<int>(count));
                for (std::size_t k = 1; k < count; ++k)
                    shares[count][k] = shares[count][k - 1] * static_cast<double>(count - k) /
                                       static_cast<double>(k);
            }
            return shares;
        }();
        return table;
    }
};

class Derivatives {
public:
    Derivatives(const BezierPatchView& patch, double rounding) : error_(rounding) {
        const double unit = patch.rational() ? 1 : 1 / patch.points.front().w;
        Net by_x{static_cast<std::size_t>(patch.degree_u) + 1,
                 static_cast<std::size_t>(patch.degree_v) + 1,
                 {patch.points.begin(), patch.points.end()}};
        for (Vec4& p : by_x.points) p *= unit;
        error_ *= unit;
        error_.w = patch.rational() ? 1e-14 * patch.points.front().w : 0;
        largest_ = by_x.most();
        // Each difference at most doubles the errors, and half the degree multiplies them.
        double growth_x = 1;
        Net net;
        for (std::size_t k = 0; k <= order; ++k, by_x.differentiate_by_x()) {
            net = by_x;
            double growth = growth_x;
            for (std::size_t l = 0; k + l <= order && !net.points.empty(); ++l) {
                all_[k][l] = {k + l <= 5 ? net.centre() : Vec4(0),
                              k + l >= 4 ? net.most() : Vec4(0), growth};
                net.differentiate_by_y(), growth *= patch.degree_v;
            }
            growth_x *= patch.degree_u;
        }
    }

    /// Taylor models of the coordinates of the derivative (k, l), by Taylor's theorem.
    std::array<TaylorModel, 4> models(std::size_t k, std::size_t l) const {
        std::array<TaylorModel, 4> m;
        // Rounding of differences and sums of up to some ten terms each; the errors of the control
        // points come on top.
        const Vec4 rounding = largest_ * 5e-15;
        Vec4 error = error_ * all_[k][l].growth;
        std::size_t index = 0;
        for (std::size_t degree = 0; degree <= 4; ++degree)
            for (std::size_t j = 0; j <= degree; ++j, ++index) {
                const Derivative& term = all_[k + degree - j][l + j];
                const double share = taylor_shares[index];
                if (degree < 4)
                    for (unsigned axis = 0; axis < 4; ++axis)
                        m[axis].c[index] = term.centre[axis] * share;
                else
                    error += term.most * share;
                error += rounding * term.growth * share;
            }
        for (unsigned axis = 0; axis < 4; ++axis) m[axis].error = error[axis];
        return m;
    }

private:
    std::array<std::array<Derivative, order + 1>, order + 1> all_; ///< by x and by y
    Vec4 error_, largest_;                                         ///< of the control points
};

} // namespace

LevelledPatch::LevelledPatch(const BezierPatchView& patch, double rounding)
    : degree_u_(patch.degree_u), degree_v_(patch.degree_v), points_(evened(patch)) {
    level(patch, points_);
    rounding_ = rounding_of(patch, points_, rounding);
}

PatchModel patch_model(const BezierPatchView& patch, double rounding) {
    const Derivatives d(patch, rounding);
    const auto of = [&](std::size_t k, std::size_t l) {
        const std::array<TaylorModel, 4> m = d.models(k, l);
        const double constant = k + l == 0 ? 1 : 0;
        return HomogeneousModel{{m[0], m[1], m[2]},
                                patch.rational() ? m[3] : TaylorModel(constant)};
    };
    return {of(0, 0), of(1, 0), of(0, 1), of(2, 0), of(1, 1), of(0, 2)};
}

} // namespace keiko
