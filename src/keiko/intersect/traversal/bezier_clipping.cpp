#include "keiko/intersect/traversal/bezier_clipping.h"

#include "keiko/geometry/bezier/robust_normal.h"
#include "keiko/intersect/roots/root_finder.h"

#include <cmath>

namespace keiko {
namespace {

/// Whether a box of several roots is a tangency, or not known. At a pole many parameters give one
/// point: several roots, yet no tangency.
bool is_tangency(const BezierPatchView& points, const SubPatchRoot& root, const Vec3& direction,
                 double size) {
    const SurfaceDerivatives s = evaluate(points, root.uv, 2);
    const auto normal = robust_normal(s, root.uv);
    constexpr double grazing = 1e-3, one_point = 1e-6;
    const double extent = s.du().length() * root.error.x + s.dv().length() * root.error.y;
    return !normal || std::abs(normal->dot(direction)) < grazing || extent > one_point * size;
}

} // namespace

void bezier_clipping(const TracedModel& model, std::uint32_t index, const TracedRay& ray,
                     bool clipping_only, std::vector<Crossing>& found) {
    thread_local RootFinder prover(false), clipper(true);
    const PlacedSubPatch& placed = model.placed[index];
    const SubPatch& sub_patch = model.sub_patches.sub_patches[placed.sub_patch];
    const PartRay part =
        model.to_part(model.placements[placed.instance], ray.start, ray.ray->direction, ray.error);
    if (!near_sub_patch(part, sub_patch)) return;
    const BezierPatchView points = model.sub_patches.view(sub_patch);
    const RayProjection view = project_ray(part, sub_patch, points);
    RootFinder& finder = clipping_only ? clipper : prover;
    for (const SubPatchRoot& root : finder.find(view.net, view.slack)) {
        const Vec3 on_sub_patch = evaluate(points, root.uv, 0).position();
        const double along = view.foot + part.direction.dot(on_sub_patch);
        Crossing c{.t = ray.t_start + along / part.speed,
                   .sub_patch = index,
                   .uv = root.uv,
                   .error = root.error};
        if (root.clipped) c.flags = c.flags | HitFlags::clipped;
        if (root.tangential && is_tangency(points, root, part.direction, sub_patch.radius))
            c.flags = c.flags | HitFlags::tangential;
        found.push_back(c);
    }
}

} // namespace keiko
