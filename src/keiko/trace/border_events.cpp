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

/// A polynomial in powers of t.
struct Powers {
    Coefficients c;

    explicit Powers(const Coefficients& bernstein) : c(bernstein) {
        static_assert(BorderPiece::points == 6);
        for (std::size_t level = 1; level < c.size(); ++level)
            for (std::size_t i = c.size() - 1; i >= level; --i) c[i] -= c[i - 1];
        c[1] *= 5, c[2] *= 10, c[3] *= 10, c[4] *= 5;
    }
    ValueAndSlope at(double t) const {
        double value = c.back(), slope = 0;
        for (std::size_t k = c.size() - 1; k-- > 0;) {
            slope = slope * t + value;
            value = value * t + c[k];
        }
        return {value, slope};
    }
};

int sign_changes(const Coefficients& c) {
    int count = 0;
    for (std::size_t i = 1; i < c.size(); ++i) count += (c[i - 1] < 0) != (c[i] < 0);
    return count;
}

/// The only zero of coefficients that change sign once, by Newton's method kept inside.
double single_root(const Coefficients& c) {
    const Powers powers(c);
    double a = 0, b = 1;
    double t = c.front() / (c.front() - c.back());
    constexpr int most_steps = 60;
    constexpr double settled = 1e-9; // the step after it is rounding
    for (int i = 0; i < most_steps; ++i) {
        const auto [value, slope] = powers.at(t);
        if (value == 0) return t;
        ((value < 0) == (c.front() < 0) ? a : b) = t;
        const double next = t - value / slope;
        const bool inside = next >= a && next <= b;
        const bool close = inside && std::abs(next - t) <= settled;
        t = inside ? next : (a + b) / 2;
        if (close || b - a <= settled * settled) break;
    }
    return t;
}

std::array<Coefficients, 2> halved(const Coefficients& c) {
    std::array<Coefficients, 2> halves{c, c};
    auto& [low, high] = halves;
    for (std::size_t level = 1; level < c.size(); ++level) {
        for (std::size_t i = 0; i + level < c.size(); ++i) high[i] = (high[i] + high[i + 1]) / 2;
        low[level] = high[0];
    }
    return halves;
}

/// Calls `add(t)` for the zeros of coefficients over [begin, end].
template <class Add>
void each_root(const Coefficients& c, double begin, double end, int most_halvings, const Add& add) {
    const auto at = [&](double t) { return begin + (end - begin) * t; };
    const int changes = sign_changes(c);
    if (changes == 0) return;
    if (changes == 1) return add(at(single_root(c)));
    if (most_halvings == 0) {
        for (const double t : bernstein_roots(c, 0)) add(at(t));
        return;
    }
    const std::array halves = halved(c);
    each_root(halves[0], begin, at(0.5), most_halvings - 1, add);
    each_root(halves[1], at(0.5), end, most_halvings - 1, add);
}

/// On which side of the border its own surface hides the segment: a ray moved along the segment
/// meets the surface's tangent plane on the material's side of the border, or beyond it.
int dark_side(const BorderPiece& border, double t, const SegmentPlane& plane) {
    constexpr double useless = 0.2;
    if (!(border.inward_error < useless)) return 0;
    const Vec3 to_border = plane.apex().way_to(border.center + border.at(t));
    // A border that the apex lies on hides nothing in a direction that rounding tells.
    constexpr double at_apex = 1e-9;
    if (!plane.apex().infinite() && !(to_border.length() > at_apex * plane.along().length()))
        return 0;
    const Vec3 way = to_border.normalized();
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
    constexpr int most_halvings = 8;
    each_root(c, 0, 1, most_halvings, add);
}

} // namespace keiko
