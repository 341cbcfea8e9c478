#include "keiko/intersect/traversal/bezier_clipping.h"

#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/intersect/roots/root_finder.h"

#include <algorithm>
#include <cmath>
#include <optional>

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

namespace {

enum class Likeness { apart, same, unclear };

/// Whether two places are one root, found twice. Where their bounds overlap but neither place is
/// within the other's, no one can tell.
Likeness likeness(const RootBoxes& roots, std::size_t a, std::size_t b) {
    constexpr double rounding = 1e-14;
    const double x = std::abs(roots.x[a] - roots.x[b]), y = std::abs(roots.y[a] - roots.y[b]);
    const auto within = [&](double reach_x, double reach_y) {
        return x <= reach_x + rounding && y <= reach_y + rounding;
    };
    if (!within(roots.half_x[a] + roots.half_x[b], roots.half_y[a] + roots.half_y[b]))
        return Likeness::apart;
    const bool inside = within(std::max(roots.half_x[a], roots.half_x[b]),
                               std::max(roots.half_y[a], roots.half_y[b]));
    return inside ? Likeness::same : Likeness::unclear;
}

/// The first finds of each root; nothing when two cannot be separated.
std::optional<std::vector<std::size_t>> distinct(const RootBoxes& roots) {
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < roots.count; ++i) {
        bool known = false;
        for (const std::size_t k : kept) {
            const Likeness alike = likeness(roots, k, i);
            if (alike == Likeness::unclear) return std::nullopt;
            known = known || alike == Likeness::same;
        }
        if (!known) kept.push_back(i);
    }
    return kept;
}

} // namespace

bool interval_newton(const TracedModel& model, const SubPatchKernels& kernels, std::uint32_t placed,
                     const RayPacket& rays, std::size_t lane, std::vector<Crossing>& found) {
    const PackedSubPatch& sub_patch = model.hot[placed];
    const Component4* polynomial = &model.sub_patches.polynomials[sub_patch.polynomial];
    RootBoxes roots;
    if (!kernels.find_roots(rays, lane, sub_patch, polynomial, roots)) return false;
    const auto kept = distinct(roots);
    if (!kept) return false;
    for (const std::size_t i : *kept)
        found.push_back({.t = rays.t_at(lane, roots.s[i]),
                         .sub_patch = placed,
                         .uv = Vec2(roots.x[i] + 1, roots.y[i] + 1) * 0.5,
                         .error = Vec2(roots.half_x[i], roots.half_y[i]) * 0.5});
    return true;
}

} // namespace keiko
