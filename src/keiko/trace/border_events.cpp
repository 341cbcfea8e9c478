#include "keiko/trace/border_events.h"

#include "keiko/patch/bernstein_roots.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

using Coefficients = std::array<double, BorderPiece::points>;

/// Distances of the control points to the plane.
Coefficients distances(const BorderPiece& border, const Vec4& weights) {
    const Vec3 normal(weights.x, weights.y, weights.z);
    Coefficients c;
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = normal.dot(border.curve[i]) + weights.w;
    return c;
}

struct ValueAndSlope {
    double value, slope;
};

ValueAndSlope evaluate(const Coefficients& c, double t) {
    Coefficients b = c;
    for (std::size_t last = b.size() - 1; last > 1; --last)
        for (std::size_t i = 0; i < last; ++i) b[i] += (b[i + 1] - b[i]) * t;
    const double rise = b[1] - b[0];
    return {b[0] + rise * t, rise * static_cast<double>(b.size() - 1)};
}

int sign_changes(const Coefficients& c) {
    int count = 0;
    for (std::size_t i = 1; i < c.size(); ++i) count += (c[i - 1] < 0) != (c[i] < 0);
    return count;
}

/// The only zero of coefficients that change sign once, by Newton's method kept inside.
double single_root(const Coefficients& c) {
    double a = 0, b = 1;
    double t = c.front() / (c.front() - c.back());
    constexpr int most_steps = 60;
    constexpr double narrow = 1e-15;
    for (int i = 0; i < most_steps && b - a > narrow; ++i) {
        const auto [value, slope] = evaluate(c, t);
        const double step = value / slope;
        if (value == 0 || std::abs(step) <= narrow) return t;
        ((value < 0) == (c.front() < 0) ? a : b) = t;
        t = t - step > a && t - step < b ? t - step : (a + b) / 2;
    }
    return t;
}

/// On which side of the border its own surface hides the segment: a ray moved along the segment
/// meets the surface's tangent plane on the material's side of the border, or beyond it.
int dark_side(const BorderPiece& border, double t, const SegmentPlane& plane) {
    constexpr double useless = 0.2;
    if (!(border.inward_error < useless)) return 0;
    const Vec3 way = plane.apex().way_to(border.center + border.at(t)).normalized();
    const Vec3 across = border.derivative(t).normalized().cross(way);
    const double inward = border.inward_at(t).normalized().dot(across);
    const double moved = plane.along().normalized().dot(across);
    const double sure = 1e-5 + border.inward_error;
    if (!(std::abs(inward) > sure && std::abs(moved) > 1e-5)) return 0;
    return (inward > 0) == (moved > 0) ? 1 : -1;
}

} // namespace

void find_border_events(const BorderPiece& border, std::span<const TrimRegion> regions,
                        const SegmentPlane& plane, std::vector<VisibilityEvent>& events) {
    const Vec4 weights = plane.weights(border.center);
    if (std::abs(weights.w) > border.radius) return;
    const Coefficients c = distances(border, weights);
    const auto [low, high] = std::minmax_element(c.begin(), c.end());
    const double slack = border.error + 1e-14 * std::max(std::abs(*low), std::abs(*high));
    if (*low > slack || *high < -slack) return;
    const auto add = [&](double t) {
        const auto s = plane.hidden_by(border.center + border.at(t));
        if (!s) return;
        if (border.trimmed &&
            !regions[border.face].contains(border.first + (border.last - border.first) * t))
            return;
        events.push_back({*s, dark_side(border, t, plane)});
    };
    // Pieces meet within rounding: a zero at an end belongs to both.
    if (std::abs(c.front()) <= slack) add(0);
    if (std::abs(c.back()) <= slack) add(1);
    const int changes = sign_changes(c);
    if (changes == 1)
        add(single_root(c));
    else if (changes > 1)
        for (const double t : bernstein_roots(c, 0)) add(t);
}

} // namespace keiko
