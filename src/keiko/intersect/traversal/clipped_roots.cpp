#include "keiko/intersect/traversal/clipped_roots.h"

#include "keiko/geometry/bezier/steady_normal.h"
#include "keiko/intersect/roots/root_finder.h"

#include <cmath>

namespace keiko {
namespace {

/// Whether a box of several roots is a tangency, or not known. At a pole many parameters give one
/// point: several roots, yet no tangency.
bool is_tangency(const BezierPatchView& points, const LeafRoot& root, const Vec3& direction,
                 double size) {
    const SurfaceDerivatives s = evaluate(points, root.uv, 2);
    const auto normal = steady_normal(s, root.uv);
    constexpr double grazing = 1e-3, one_point = 1e-6;
    const double extent = s.du().length() * root.error.x + s.dv().length() * root.error.y;
    return !normal || std::abs(normal->dot(direction)) < grazing || extent > one_point * size;
}

} // namespace

void clipped_roots(const TracedModel& model, std::uint32_t index, const TracedRay& ray,
                   bool clipping_only, std::vector<Crossing>& found) {
    thread_local RootFinder prover(false), clipper(true);
    const PlacedLeaf& placed = model.placed[index];
    const Leaf& leaf = model.leaves.leaves[placed.leaf];
    const PartRay part =
        model.to_part(model.placements[placed.instance], ray.start, ray.ray->direction, ray.error);
    if (!near_leaf(part, leaf)) return;
    const BezierPatchView points = model.leaves.view(leaf);
    const LeafView view = look_at(part, leaf, points);
    RootFinder& finder = clipping_only ? clipper : prover;
    for (const LeafRoot& root : finder.find(view.net, view.slack)) {
        const Vec3 on_leaf = evaluate(points, root.uv, 0).position();
        const double along = view.foot + part.direction.dot(on_leaf);
        Crossing c{.t = ray.t_start + along / part.speed,
                   .leaf = index,
                   .uv = root.uv,
                   .error = root.error};
        if (root.clipped) c.flags = c.flags | HitFlags::clipped;
        if (root.tangential && is_tangency(points, root, part.direction, leaf.radius))
            c.flags = c.flags | HitFlags::tangential;
        found.push_back(c);
    }
}

} // namespace keiko
