#include "keiko/visibility/boundaries/boundary_events.h"

#include "keiko/visibility/boundaries/plane_cuts.h"

#include <algorithm>
#include <cmath>

namespace keiko {
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
