#include "keiko/visibility/boundaries/plane_cuts.h"

#include <algorithm>
#include <cmath>

namespace keiko {

namespace {

constexpr std::size_t degree = BoundaryPiece::points - 1;

struct ValueAndSlope {
    double value, slope;
};

/// A polynomial in powers of t.
struct Powers {
    PlaneDistances c;

    explicit Powers(const PlaneDistances& bernstein) : c(bernstein) {
        static_assert(degree == 5);
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

} // namespace

int sign_changes(const PlaneDistances& c) {
    int count = 0;
    for (std::size_t i = 1; i < c.size(); ++i) count += (c[i - 1] < 0) != (c[i] < 0);
    return count;
}

double single_zero(const PlaneDistances& c, double settled) {
    const Powers powers(c);
    double a = 0, b = 1;
    double t = c.front() / (c.front() - c.back());
    constexpr int most_steps = 60;
    constexpr double narrowest = 1e-18;
    for (int i = 0; i < most_steps; ++i) {
        const auto [value, slope] = powers.at(t);
        if (value == 0) return t;
        ((value < 0) == (c.front() < 0) ? a : b) = t;
        const double next = t - value / slope;
        const bool inside = next >= a && next <= b;
        const bool close = inside && std::abs(next - t) <= settled;
        t = inside ? next : (a + b) / 2;
        if (close || b - a <= narrowest) break;
    }
    return t;
}

PlaneDistances slope_of(const PlaneDistances& c) {
    PlaneDistances slope{};
    for (std::size_t i = 0; i < degree; ++i) {
        const double step = c[i + 1] - c[i], share = static_cast<double>(i) / degree;
        slope[i] += step * (1 - share);
        slope[i + 1] += step * (share + 1.0 / degree);
    }
    return slope;
}

double value_at(const PlaneDistances& c, double t) {
    return Powers(c).at(t).value;
}

namespace {

PlaneDistances distances(const BoundaryPiece& border, const Vec4& weights) {
    const Vec3 normal(weights.x, weights.y, weights.z);
    PlaneDistances c;
    for (std::size_t i = 0; i < c.size(); ++i) c[i] = normal.dot(border.curve[i]) + weights.w;
    return c;
}

/// On which side of the border its own surface hides the segment: a ray moved along the segment
/// meets the surface's tangent plane on the material's side of the border, or beyond it.
int dark_side(const BoundaryPiece& border, double t, const SegmentPlane& plane) {
    constexpr double useless = 0.2;
    if (!(border.inward_error < useless)) return 0;
    const Vec3 to_border = plane.viewpoint().way_to(border.center + border.at(t));
    // A border that the viewpoint lies on hides nothing in a direction that rounding tells.
    constexpr double at_apex = 1e-9;
    if (!plane.viewpoint().infinite() && !(to_border.length() > at_apex * plane.along().length()))
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

void find_border_events(const BoundaryPiece& border, std::span<const TrimRegion> regions,
                        const SegmentPlane& plane, std::vector<VisibilityEvent>& events) {
    const Vec4 weights = plane.weights(border.center);
    if (std::abs(weights.w) > border.radius) return;
    const PlaneDistances c = distances(border, weights);
    double largest = 0;
    for (const double distance : c) largest = std::max(largest, std::abs(distance));
    constexpr double rounding = 1e-14, settled = 1e-9;
    each_cut(c, border.error + rounding * largest, settled, [&](const PlaneCut& cut) {
        const auto s = plane.hidden_by(border.center + border.at(cut.t));
        if (!s) return;
        const Vec2 place = border.first + (border.last - border.first) * cut.t;
        if (border.trimmed && !regions[border.face].contains(place)) return;
        events.push_back({*s, cut.rising == 0 ? 0 : dark_side(border, cut.t, plane)});
    });
}

} // namespace keiko
