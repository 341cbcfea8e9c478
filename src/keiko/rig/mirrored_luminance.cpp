#include "keiko/rig/mirrored_luminance.h"

#include "keiko/luminance/compositing.h"

#include <algorithm>

namespace keiko {
namespace {

struct PlaneOnRay {
    std::size_t source = 0;
    CPlaneFrame frame;
    CPlaneHit hit;
};

/// Answers whether and where a ray meets the extent of a source.
struct MeetsPlane {
    const Vec3 &origin, &direction;

    std::optional<PlaneOnRay> operator()(const CPlane& plane) const {
        const CPlaneFrame frame(plane);
        const auto hit = c_plane_coordinates(frame, origin, direction);
        if (!hit) return {};
        return PlaneOnRay{0, frame, *hit};
    }
    std::optional<PlaneOnRay> operator()(const Spotlight&) const { return {}; }
    std::optional<PlaneOnRay> operator()(const Luminaire&) const { return {}; }
    std::optional<PlaneOnRay> operator()(const Sun&) const { return {}; }
};

/// C-planes on the ray, nearest first; planes at one distance in the order of the rig.
std::vector<PlaneOnRay> planes_on(const LightRig& rig, const Vec3& origin, const Vec3& direction) {
    std::vector<PlaneOnRay> planes;
    for (std::size_t i = 0; i < rig.sources.size(); ++i) {
        if (auto plane = std::visit(MeetsPlane{origin, direction}, rig.sources[i])) {
            plane->source = i;
            planes.push_back(*plane);
        }
    }
    std::stable_sort(planes.begin(), planes.end(),
                     [](const auto& a, const auto& b) { return a.hit.t < b.hit.t; });
    return planes;
}

} // namespace

MirroredLight mirrored_luminance(const LightRig& rig, const Vec3& origin, const Vec3& direction,
                                 const std::optional<RayDifferentials>& spread, double t_max) {
    FrontToBack rows;
    bool resolved = true;
    for (const PlaneOnRay& plane : planes_on(rig, origin, direction)) {
        if (!(plane.hit.t <= t_max)) break;
        const Footprint footprint =
            spread ? footprint_on(plane.frame, plane.hit, direction, *spread) : Footprint();
        const CPlane& source = std::get<CPlane>(rig.sources[plane.source]);
        const StripeLook row = look_up(plane.frame, origin, direction, footprint, source.mirror);
        rows.add(source.luminance, row.coverage);
        resolved = resolved && (row.resolved || row.coverage == 0);
    }
    return {rows.light, rows.opacity, resolved};
}

std::optional<RigPlaneHit> nearest_c_plane(const LightRig& rig, const Vec3& origin,
                                           const Vec3& direction) {
    const auto planes = planes_on(rig, origin, direction);
    if (planes.empty()) return {};
    return RigPlaneHit{planes.front().source, planes.front().hit};
}

} // namespace keiko
