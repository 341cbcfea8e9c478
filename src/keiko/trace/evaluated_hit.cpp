#include "keiko/trace/evaluated_hit.h"

#include "keiko/trace/steady_normal.h"
#include "keiko/trace/surface_jet.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// In the world, by patch parameters, from a leaf's own.
SurfaceJet in_world(const SurfaceJet& local, const Leaf& leaf, const PartPlacement& placement) {
    const Vec2 scale = Vec2(1) / leaf.domain.extent();
    SurfaceJet world{leaf.center + local.position,
                     local.du * scale.x,
                     local.dv * scale.y,
                     local.duu * (scale.x * scale.x),
                     local.duv * (scale.x * scale.y),
                     local.dvv * (scale.y * scale.y)};
    if (placement.identity) return world;
    world.position = placement.to_world.point(world.position);
    for (Vec3* d : {&world.du, &world.dv, &world.duu, &world.duv, &world.dvv})
        *d = placement.to_world.vector(*d);
    return world;
}

/// The limit normal where there is one, else one across the ray's own leaf.
Vec3 normal_of(const SurfaceJet& s, const Vec2& uv, const BezierPatchView& leaf,
               const PartPlacement& placement) {
    const Vec3 across = s.du.cross(s.dv);
    const double area2 = across.length2(), u2 = s.du.length2(), v2 = s.dv.length2();
    // Far from any pole there is nothing to think about.
    constexpr double small = 1e-8;
    if (area2 > small * u2 * v2 && std::min(u2, v2) > small * s.duv.length2())
        return across / std::sqrt(area2);
    if (const auto normal = steady_normal(s.derivatives(), uv)) return *normal;
    const SurfaceDerivatives middle = evaluate(leaf, Vec2(0.5), 1);
    return placement.to_world.vector(middle.du())
        .cross(placement.to_world.vector(middle.dv()))
        .normalized();
}

/// How far a small step in parameters moves the point: the second order counted twice, which
/// covers what follows it.
double reach_of(const SurfaceJet& s, const Vec2& step) {
    return s.du.length() * step.x + s.dv.length() * step.y + s.duu.length() * step.x * step.x +
           2 * s.duv.length() * step.x * step.y + s.dvv.length() * step.y * step.y;
}

Box2 root_box(const Vec2& uv, const Vec2& error) {
    // Less would be lost in the rounding of the next ray's own start.
    constexpr double least = 1e-9;
    const Vec2 half(std::max(least, 4 * error.x), std::max(least, 4 * error.y));
    return {uv - half, uv + half};
}

} // namespace

Hit evaluated(const TracedModel& model, const LeafKernels& kernels, const Crossing& c,
              bool second_derivatives) {
    const PlacedLeaf& placed = model.placed[c.leaf];
    const Leaf& leaf = model.leaves.leaves[placed.leaf];
    const PartPlacement& placement = model.placements[placed.instance];
    const BezierPatchView points = model.leaves.view(leaf);
    const Vec2 extent = leaf.domain.extent();
    const Vec2 beyond = leaf.patch_parameters(c.uv);
    const Vec2 uv = unit_square.nearest(beyond);
    const HomogeneousJet jet = kernels.evaluate(points, (uv - leaf.domain.lower) / extent);
    const SurfaceJet s = in_world(projected(jet, model.hot[c.leaf].rational), leaf, placement);

    Hit hit;
    hit.t = c.t;
    hit.instance = placed.instance;
    hit.patch = leaf.patch;
    hit.face = model.patches[leaf.patch].face;
    hit.uv = uv;
    hit.position = s.position;
    hit.dpdu = s.du;
    hit.dpdv = s.dv;
    hit.normal = normal_of(s, uv, points, placement);
    if (second_derivatives) hit.second = SecondDerivatives{s.duu, s.duv, s.dvv};
    hit.flags = c.flags;
    if (c.seam != no_index) hit.seam = c.seam;

    const Vec2 off(std::abs(beyond.x - uv.x), std::abs(beyond.y - uv.y));
    const Vec2 error = c.error * extent;
    const double steps = 8 + 4.0 * (leaf.degree_u + leaf.degree_v);
    const double rounding =
        epsilon * (8 * hit.position.length() + steps * leaf.radius * placement.magnification);
    hit.position_bound =
        reach_of(s, error + off) + leaf.coefficient_error * placement.magnification + rounding;
    hit.root = {hit.instance, hit.patch, root_box(uv, error + off)};
    return hit;
}

} // namespace keiko
