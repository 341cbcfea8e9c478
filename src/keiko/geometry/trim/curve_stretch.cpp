#include "keiko/geometry/trim/curve_stretch.h"

#include "keiko/geometry/bezier/parameter_ranges.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Ranges of a function of s and of its first two derivatives.
struct Series {
    Interval value, first, second;
};

Series operator/(const Series& a, const Series& b) {
    const Interval value = a.value / b.value;
    const Interval first = (a.first - value * b.first) / b.value;
    return {value, first,
            (a.second - first * b.first * Interval(2.0) - value * b.second) / b.value};
}

/// Ranges of a polynomial, from the hulls of its Bernstein coefficients and of their differences.
Series series_of(const BernsteinField& field) {
    const BernsteinField slope = field.derivative(true);
    return {field.range(), slope.range(), slope.derivative(true).range()};
}

/// A coordinate of the curve less that of its start, times the weight.
BernsteinField coordinate(const std::vector<Vec3>& points, unsigned axis, double start) {
    std::vector<double> coefficients;
    double largest = 0;
    for (const Vec3& p : points) {
        coefficients.push_back(p[axis] - start * p.z);
        largest = std::max(largest, std::abs(p[axis]) + std::abs(start * p.z));
    }
    constexpr double rounding = 4e-16;
    return {static_cast<int>(points.size()) - 1, 0, std::move(coefficients), rounding * largest};
}

BernsteinField weights(const std::vector<Vec3>& points) {
    std::vector<double> coefficients;
    for (const Vec3& p : points) coefficients.push_back(p.z);
    return {static_cast<int>(points.size()) - 1, 0, std::move(coefficients), 0};
}

/// Rates of the local parameter of a box of a patch, from the series of the face's parameter.
/// `patch`: the range of the patch's own parameter over the box.
CurveStretch::Rates through(const ParameterMap& map, const Series& face, const Interval& patch) {
    const ParameterRanges by_patch = parameter_ranges(map, patch);
    const Interval first = face.first / by_patch.first;
    const Interval second = (face.second - by_patch.second * square(first)) / by_patch.first;
    const Interval extent(patch.high - patch.low);
    return {first / extent, second / extent};
}

Vec2 projected(const Vec3& p) {
    return Vec2(p.x, p.y) / p.z;
}

} // namespace

CurveStretch::CurveStretch(std::vector<Vec3> points, double share)
    : points_(std::move(points)),
      first_(projected(points_.front())),
      last_(projected(points_.back())),
      share_(share) {}

std::array<CurveStretch, 2> CurveStretch::halves() const {
    std::vector<Vec3> left = points_, right = points_;
    const std::size_t n = points_.size();
    for (std::size_t level = 1; level < n; ++level)
        for (std::size_t i = 0; i + level < n; ++i) {
            right[i] = (right[i] + right[i + 1]) * 0.5;
            if (i == 0) left[level] = right[0];
        }
    return {CurveStretch(std::move(left), share_ / 2), CurveStretch(std::move(right), share_ / 2)};
}

CurveStretch::Rates CurveStretch::rates(const Patch& patch, const PatchHeight& around) const {
    const Series w = series_of(weights(points_));
    const auto series = [&](unsigned axis) {
        return series_of(coordinate(points_, axis, first_[axis])) / w;
    };
    const Box2& box = around.uv();
    const Rates x = through(patch.map_u, series(0), {box.lower.x, box.upper.x});
    const Rates y = through(patch.map_v, series(1), {box.lower.y, box.upper.y});
    const PatchHeight::Slopes f = around.slopes();
    return {f.x * x.first + f.y * y.first,
            f.xx * square(x.first) + f.xy * x.first * y.first * Interval(2.0) +
                f.yy * square(y.first) + f.x * x.second + f.y * y.second};
}

std::vector<CurveStretch> border_of(const SurfaceModel& model, const Face& face) {
    std::vector<CurveStretch> border;
    for (const TrimLoop& loop : model.loops_of(face)) {
        const std::size_t begin = border.size();
        for (std::uint32_t c = 0; c < loop.curve_count; ++c)
            border.emplace_back(model.trim_curve(loop.first_curve + c));
        for (std::size_t k = begin, end = border.size(); k < end; ++k) {
            const Vec2 from = border[k].last(), to = border[k + 1 < end ? k + 1 : begin].first();
            if (from != to) border.emplace_back(from, to);
        }
    }
    return border;
}

} // namespace keiko
