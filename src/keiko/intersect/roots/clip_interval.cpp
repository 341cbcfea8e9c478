#include "keiko/intersect/roots/clip_interval.h"

#include "keiko/geometry/bernstein/bernstein.h"

#include <algorithm>
#include <array>
#include <limits>

namespace keiko {
namespace {

constexpr ParameterInterval nothing{1, 0};

/// Heights at equally spaced places from 0 to 1.
struct Profile {
    std::array<double, max_degree + 1> height;
    std::size_t count;
};

/// Where the lower convex hull of a profile is at most zero: outside of it the hull stays above,
/// bounded by the steepest chord from a positive height down to a negative one.
ParameterInterval below_zero(const Profile& p) {
    const std::size_t n = p.count - 1;
    if (n == 0) return p.height[0] <= 0 ? ParameterInterval{0, 1} : nothing;
    const auto crossing = [&](std::size_t above, std::size_t below) {
        const double x = static_cast<double>(above), y = static_cast<double>(below);
        return (x + (y - x) * (p.height[above] / (p.height[above] - p.height[below]))) /
               static_cast<double>(n);
    };
    double begin = p.height[0] <= 0 ? 0 : 2, end = p.height[n] <= 0 ? 1 : -1;
    for (std::size_t i = 0; i <= n; ++i) {
        if (!(p.height[i] > 0)) continue;
        for (std::size_t k = i + 1; k <= n; ++k)
            if (p.height[k] <= 0) begin = std::min(begin, crossing(i, k));
        for (std::size_t k = 0; k < i; ++k)
            if (p.height[k] <= 0) end = std::max(end, crossing(i, k));
    }
    if (begin > 1 || end < 0) return nothing; // positive everywhere
    return {begin, end};
}

} // namespace

ParameterInterval clip_interval(std::span<const double> net, std::size_t rows, std::size_t columns,
                                Axis axis, double slack) {
    const std::size_t count = axis == Axis::u ? rows : columns;
    const std::size_t across = axis == Axis::u ? columns : rows;
    const std::size_t step = axis == Axis::u ? columns : 1;
    const std::size_t stride = axis == Axis::u ? 1 : columns;
    Profile low, minus_high;
    low.count = minus_high.count = count;
    for (std::size_t i = 0; i < count; ++i) {
        const double* c = net.data() + i * step;
        double lowest = c[0], highest = c[0];
        for (std::size_t k = 1; k < across; ++k) {
            lowest = std::min(lowest, c[k * stride]);
            highest = std::max(highest, c[k * stride]);
        }
        low.height[i] = lowest - slack;
        minus_high.height[i] = -highest - slack;
    }
    const ParameterInterval a = below_zero(low), b = below_zero(minus_high);
    // The division above rounds; an interval may only ever be too wide.
    constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();
    const double begin = std::max(a.begin, b.begin) - rounding;
    const double end = std::min(a.end, b.end) + rounding;
    return begin <= end ? ParameterInterval{std::max(begin, 0.0), std::min(end, 1.0)} : nothing;
}

} // namespace keiko
