#include "keiko/inspect/basics/patch_model.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

/// Order of the models. One more is needed for their remainders, and two for the second
/// derivatives.
constexpr std::size_t order = 6;

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
        const std::vector<double> by_row = central_shares(rows),
                                  by_column = central_shares(columns);
        Vec4 sum(0);
        for (std::size_t i = 0; i < rows; ++i) {
            Vec4 row(0);
            for (std::size_t j = 0; j < columns; ++j) row += points[i * columns + j] * by_column[j];
            sum += row * by_row[i];
        }
        return sum;
    }

private:
    /// The Bernstein polynomials at 1/2.
    static std::vector<double> central_shares(std::size_t count) {
        std::vector<double> shares(count, std::ldexp(1.0, 1 - static_cast<int>(count)));
        for (std::size_t k = 1; k < count; ++k)
            shares[k] = shares[k - 1] * static_cast<double>(count - k) / static_cast<double>(k);
        return shares;
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
        for (std::size_t k = 0; k <= order; ++k, by_x.differentiate_by_x()) {
            Net net = by_x;
            double growth = growth_x;
            for (std::size_t l = 0; k + l <= order && !net.points.empty(); ++l) {
                all_[k][l] = {k + l <= 5 ? net.centre() : Vec4(0),
                              k + l >= 4 ? net.most() : Vec4(0), growth};
                net.differentiate_by_y(), growth *= patch.degree_v;
            }
            growth_x *= patch.degree_u;
        }
    }

    /// Taylor model of the derivative (k, l) along one axis, by Taylor's theorem.
    TaylorModel model(std::size_t k, std::size_t l, int axis) const {
        constexpr double factorial[] = {1, 1, 2, 6, 24};
        // Rounding of differences and sums of up to some ten terms each; the errors of the control
        // points come on top.
        const double rounding = 5e-15 * largest_[axis];
        TaylorModel m;
        m.error = error_[axis] * all_[k][l].growth;
        std::size_t index = 0;
        for (std::size_t degree = 0; degree <= 4; ++degree)
            for (std::size_t j = 0; j <= degree; ++j) {
                const Derivative& term = all_[k + degree - j][l + j];
                const double share = 1 / (factorial[degree - j] * factorial[j]);
                if (degree < 4)
                    m.c[index++] = term.centre[axis] * share;
                else
                    m.error += term.most[axis] * share;
                m.error += rounding * term.growth * share;
            }
        return m;
    }

private:
    std::array<std::array<Derivative, order + 1>, order + 1> all_; ///< by x and by y
    Vec4 error_, largest_;                                         ///< of the control points
};

} // namespace

PatchModel patch_model(const BezierPatchView& patch, double rounding) {
    const Derivatives d(patch, rounding);
    const auto of = [&](std::size_t k, std::size_t l) {
        const double constant = k + l == 0 ? 1 : 0;
        return HomogeneousModel{{d.model(k, l, 0), d.model(k, l, 1), d.model(k, l, 2)},
                                patch.rational() ? d.model(k, l, 3) : TaylorModel(constant)};
    };
    return {of(0, 0), of(1, 0), of(0, 1), of(2, 0), of(1, 1), of(0, 2)};
}

} // namespace keiko
