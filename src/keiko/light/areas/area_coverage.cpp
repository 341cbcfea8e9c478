#include "keiko/light/areas/area_coverage.h"

#include "keiko/light/areas/plane_footprint.h"
#include "keiko/math/bounds.h"

#include <algorithm>
#include <vector>

namespace keiko {

PanelOutline::PanelOutline(const PolygonLight& light)
    : plane(light.corners.front(), light.normal()), two_sided(light.two_sided) {
    Box2 box;
    for (const Vec3& corner : light.corners) {
        corners.push_back(plane.place(corner));
        box.extend(corners.back());
    }
    middle = (box.lower + box.upper) / 2;
    for (const Vec2& corner : corners) reach = std::max(reach, (corner - middle).length());
}

std::optional<AreaHit> area_hit(const PanelOutline& panel, const Vec3& origin,
                                const Vec3& direction,
                                const std::optional<RayDifferentials>& spread) {
    if (!panel.two_sided && !(panel.plane.normal.dot(origin - panel.plane.origin) > 0))
        return std::nullopt;
    const auto foot = footprint_on(panel.plane, origin, direction, spread);
    if (!foot || (foot->hit - panel.middle).length() > panel.reach + foot->reach())
        return std::nullopt;
    return hit_of(foot->t, share_in_polygon(*foot, panel.corners));
}

} // namespace keiko
