#include "keiko/inspect/derivative_ranges.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {
namespace {

constexpr std::size_t order = 4;
/// Control points of a derivative, u outer; none where it vanishes.
struct Net {
    std::size_t rows = 0, columns = 0;
    std::vector<Vec4> points;

    void differentiate_by_u() {
        if (rows < 2 || points.empty()) return points.clear();
        const double degree = static_cast<double>(--rows);
        for (std::size_t i = 0; i < rows * columns; ++i)
            points[i] = (points[i + columns] - points[i]) * degree;
        points.resize(rows * columns);
    }
    void differentiate_by_v() {
        if (columns < 2 || points.empty()) return points.clear();
        const double degree = static_cast<double>(columns - 1);
        for (std::size_t i = 0; i < rows; ++i)
            for (std::size_t j = 0; j + 1 < columns; ++j)
                points[i * (columns - 1) + j] =
                    (points[i * columns + j + 1] - points[i * columns + j]) * degree;
        --columns;
        points.resize(rows * columns);
    }
    HomogeneousRange hull(const Vec4& error) const {
        if (points.empty()) return {};
        Vec4 low = points.front(), high = low;
        for (const Vec4& p : points)
            for (int axis = 0; axis < 4; ++axis) {
                low[axis] = std::min(low[axis], p[axis]);
                high[axis] = std::max(high[axis], p[axis]);
            }
        return padded(low, high, error);
    }
    /// By averages, each of which rounds by less than `error`, which all of them share.
    HomogeneousRange centre(const Vec4& error) const {
        if (points.empty()) return {};
        std::vector<Vec4> line(points);
        for (std::size_t n = rows; n > 1; --n)
            for (std::size_t i = 0; i < (n - 1) * columns; ++i)
                line[i] = (line[i] + line[i + columns]) * 0.5;
        for (std::size_t n = columns; n > 1; --n)
            for (std::size_t j = 0; j + 1 < n; ++j) line[j] = (line[j] + line[j + 1]) * 0.5;
        return padded(line.front(), line.front(), error);
    }

private:
    static HomogeneousRange padded(const Vec4& low, const Vec4& high, const Vec4& error) {
        const auto range = [&](int axis) {
            return Interval(low[axis], high[axis]).padded(error[axis]);
        };
        return {{range(0), range(1), range(2)}, range(3)};
    }
};

} // namespace

DerivativeRanges derivative_ranges(const BezierPatchView& patch, double rounding) {
    const double weight_rounding = patch.rational() ? 1e-14 * patch.points.front().w : 0;
    const double twice_u = 2.0 * patch.degree_u, twice_v = 2.0 * patch.degree_v;
    DerivativeRanges ranges{};
    Net by_u{static_cast<std::size_t>(patch.degree_u) + 1,
             static_cast<std::size_t>(patch.degree_v) + 1,
             {patch.points.begin(), patch.points.end()}};
    for (std::size_t k = 0; k <= order; ++k, by_u.differentiate_by_u()) {
        Net net = by_u;
        for (std::size_t l = 0; k + l <= order; ++l, net.differentiate_by_v()) {
            // Each difference at most doubles the errors, and the degree multiplies them.
            const double growth = std::pow(twice_u, double(k)) * std::pow(twice_v, double(l));
            const double place = rounding * growth;
            const Vec4 error(place, place, place, weight_rounding * growth);
            ranges.all[k][l] = net.hull(error);
            ranges.centre[k][l] = net.centre(error);
        }
    }
    return ranges;
}

} // namespace keiko
