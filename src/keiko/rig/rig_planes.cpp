#include "keiko/rig/rig_planes.h"

#include "keiko/luminance/compositing.h"

#include <algorithm>

namespace keiko {

RigPlanes::RigPlanes(const LightRig& rig) {
    for (std::size_t i = 0; i < rig.sources.size(); ++i)
        if (const auto* plane = std::get_if<CPlane>(&rig.sources[i]))
            planes_.push_back({i, CPlaneFrame(*plane), plane->luminance, plane->mirror});
}

std::optional<RigPlanes::OnRay> RigPlanes::next(const Vec3& origin, const Vec3& direction,
                                                const std::optional<OnRay>& last) const {
    std::optional<OnRay> nearest;
    for (const Plane& plane : planes_) {
        const auto hit = c_plane_coordinates(plane.frame, origin, direction);
        if (!hit || (last && (hit->t < last->hit.t ||
                              (hit->t == last->hit.t && plane.source <= last->plane->source))))
            continue;
        if (!nearest || hit->t < nearest->hit.t) nearest = OnRay{&plane, *hit};
    }
    return nearest;
}

MirroredLight RigPlanes::luminance(const Vec3& origin, const Vec3& direction,
                                   const std::optional<RayDifferentials>& spread,
                                   double t_max) const {
    FrontToBack rows;
    bool resolved = true;
    for (auto on = next(origin, direction, {}); on && on->hit.t <= t_max;
         on = next(origin, direction, on)) {
        const CPlaneFrame& frame = on->plane->frame;
        const Footprint footprint =
            spread ? footprint_on(frame, on->hit, direction, *spread) : Footprint();
        const StripeLook row = look_up(frame, origin, direction, footprint, on->plane->mirror);
        rows.add(on->plane->luminance, row.coverage);
        resolved = resolved && (row.resolved || row.coverage == 0);
    }
    return {rows.light, rows.opacity, resolved};
}

std::optional<RigPlaneHit> RigPlanes::nearest(const Vec3& origin, const Vec3& direction) const {
    const auto on = next(origin, direction, {});
    if (!on) return {};
    return RigPlaneHit{on->plane->source, on->hit, &on->plane->frame};
}

} // namespace keiko
