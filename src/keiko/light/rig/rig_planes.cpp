#include "keiko/light/rig/rig_planes.h"

#include "keiko/light/luminance/front_to_back.h"

#include <algorithm>
#include <cmath>

namespace keiko {

namespace {

/// True if planes are identical to within the rounding of their numbers.
bool in_one_plane(const CPlaneFrame& a, const CPlaneFrame& b) {
    constexpr double rounding = 1e-14;
    const double size = a.origin.length() + b.origin.length() + a.length + b.length;
    return a.normal.cross(b.normal).length() <= 10 * rounding &&
           std::abs(a.normal.dot(b.origin - a.origin)) <= rounding * size;
}

} // namespace

RigPlanes::RigPlanes(const LightRig& rig) {
    for (std::size_t i = 0; i < rig.sources.size(); ++i)
        if (const auto* row = std::get_if<CPlane>(&rig.sources[i])) {
            const CPlaneFrame frame(*row);
            const auto same = std::find_if(planes_.begin(), planes_.end(), [&](const Plane& other) {
                return in_one_plane(other.frame, frame);
            });
            const std::size_t level = same == planes_.end() ? planes_.size() : same->level;
            planes_.push_back({i, frame, row->luminance, row->mirror, level});
        }
}

std::optional<CPlaneHit> RigPlanes::meet(const Plane& plane, const Vec3& origin,
                                         const Vec3& direction) const {
    auto hit = c_plane_coordinates(plane.frame, origin, direction);
    const Plane& level = planes_[plane.level];
    if (hit && &level != &plane)
        hit->t = c_plane_coordinates(level.frame, origin, direction).value_or(*hit).t;
    return hit;
}

std::optional<RigPlaneHit> RigPlanes::next(const Vec3& origin, const Vec3& direction,
                                           const std::optional<RigPlaneHit>& last) const {
    std::optional<RigPlaneHit> nearest;
    for (std::size_t i = 0; i < planes_.size(); ++i) {
        const Plane& plane = planes_[i];
        if (last && last->number == i) continue;
        const auto hit = meet(plane, origin, direction);
        if (!hit || (last && (hit->t < last->at.t ||
                              (hit->t == last->at.t && plane.source <= last->source))))
            continue;
        if (!nearest || hit->t < nearest->at.t)
            nearest = RigPlaneHit{plane.source, *hit, &plane.frame, i};
    }
    return nearest;
}

MirroredLight RigPlanes::luminance(const Vec3& origin, const Vec3& direction,
                                   const std::optional<RayDifferentials>& spread,
                                   double t_max) const {
    return luminance(nearest(origin, direction), origin, direction, spread, t_max);
}

MirroredLight RigPlanes::luminance(const std::optional<RigPlaneHit>& nearest, const Vec3& origin,
                                   const Vec3& direction,
                                   const std::optional<RayDifferentials>& spread,
                                   double t_max) const {
    FrontToBack rows;
    bool resolved = true;
    double t = std::numeric_limits<double>::infinity();
    for (auto on = nearest; on && on->at.t <= t_max; on = next(origin, direction, on)) {
        const CPlaneFrame& frame = *on->frame;
        const Plane& plane = planes_[on->number];
        const Footprint footprint = spread ? footprint_on(frame, on->at, *spread) : Footprint();
        const LampCoverage row = look_up(frame, on->at, origin, direction, footprint, plane.mirror);
        if (row.coverage > 0) t = std::min(t, on->at.t);
        rows.add(plane.luminance, row.coverage);
        resolved = resolved && (row.resolved || row.coverage == 0);
    }
    return {rows.light, rows.opacity, resolved, t};
}

bool RigPlanes::are_missed_by(const RayCone& rays) const {
    return std::all_of(planes_.begin(), planes_.end(),
                       [&](const Plane& plane) { return misses_lamps(plane.frame, rays); });
}

std::optional<RigPlaneHit> RigPlanes::nearest(const Vec3& origin, const Vec3& direction) const {
    return next(origin, direction, {});
}

} // namespace keiko
