#include "keiko/trace/leaf_hits.h"

#include "keiko/patch/differential_geometry.h"
#include "keiko/trace/root_finder.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>

namespace keiko {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

Vec2 clamped(const Vec2& uv) {
    return {std::clamp(uv.x, 0.0, 1.0), std::clamp(uv.y, 0.0, 1.0)};
}

Vec2 patch_parameters(const Leaf& leaf, const Vec2& uv) {
    return leaf.domain.lower + leaf.domain.extent() * uv;
}

/// unit_normal, but where one tangent is all but gone (within 1e-8 of the way to a pole) it is
/// taken as gone: what is left of it is rounding, and the pole's own normal is closer.
std::optional<Vec3> steady_normal(SurfaceDerivatives s, const Vec2& uv) {
    constexpr double gone = 1e-8;
    const double mixed = s.duv().length();
    if (s.du().length() < gone * mixed) s.d[1][0] = s.d[2][0] = Vec3(0);
    if (s.dv().length() < gone * mixed) s.d[0][1] = s.d[0][2] = Vec3(0);
    return unit_normal(s, uv);
}

/// Tests the roots of one ray on one leaf.
class LeafTest {
public:
    LeafTest(const TracedModel& model, const PlacedLeaf& placed, const TracedRay& ray)
        : model_(model),
          placed_(placed),
          leaf_(model.leaves.leaves[placed.leaf]),
          points_(model.leaves.view(leaf_)),
          patch_(model.patches[leaf_.patch]),
          world_(ray),
          part_(model.to_part(model.placements[placed.instance], ray.start, ray.ray->direction,
                              ray.error)) {}

    void collect(RootFinder& finder, double limit, std::vector<Candidate>& found) {
        if (!near_leaf(part_, leaf_)) return;
        const LeafView view = look_at(part_, leaf_, points_);
        const double last = std::min(world_.ray->t_max, limit);
        for (const LeafRoot& root : finder.find(view.net, view.slack)) {
            const Vec3 on_leaf = evaluate(points_, root.uv, 0).position();
            const double along = view.foot + part_.direction.dot(on_leaf);
            Candidate c{world_.t_start + along / part_.speed, placed_, root.uv, root.error};
            if (!(c.t >= world_.ray->t_min && c.t <= last)) continue;
            if (root.clipped) c.flags = c.flags | HitFlags::clipped;
            if (root.tangential && grazes(root)) c.flags = c.flags | HitFlags::tangential;
            if (!is_excluded(c) && is_material(c)) found.push_back(c);
        }
    }

private:
    /// At a pole many parameters give one point: several roots, yet no tangency.
    bool grazes(const LeafRoot& root) const {
        const SurfaceDerivatives s = evaluate(points_, root.uv, 2);
        const std::optional<Vec3> normal = steady_normal(s, root.uv);
        constexpr double grazing = 1e-3;
        return !normal || std::abs(normal->dot(part_.direction)) < grazing;
    }

    bool is_excluded(const Candidate& c) const {
        const std::optional<Root>& root = world_.ray->excluded;
        if (!root || root->instance != placed_.instance) return false;
        if (root->patch == leaf_.patch && root->uv.contains(patch_parameters(leaf_, c.uv)))
            return true;
        const double from_start = c.t * part_.speed;
        const double from_end = (world_.ray->t_max - c.t) * part_.speed;
        const double distance = std::min(std::abs(from_start), std::abs(from_end));
        // Farther off than this no rounding carries a root, whatever the angle.
        if (!(distance <= 1e-3 * leaf_.radius)) return false;
        const std::optional<Vec3> normal = steady_normal(evaluate(points_, c.uv, 2), c.uv);
        const double sine = normal ? std::abs(normal->dot(part_.direction)) : 1;
        const double rounding =
            64 * epsilon * (part_.origin.length() + leaf_.center.length() + leaf_.radius) +
            4 * part_.error;
        return distance * sine <= rounding;
    }

    bool is_material(Candidate& c) const {
        const FaceTrim& trim = model_.faces[patch_.face];
        if (trim.region.untrimmed()) return true;
        const Vec2 uv = patch_parameters(leaf_, c.uv), inside = clamped(uv);
        const Vec2 allowed = leaf_.slip + c.error * leaf_.domain.extent();
        const bool on_patch =
            std::abs(uv.x - inside.x) <= allowed.x && std::abs(uv.y - inside.y) <= allowed.y;
        if (on_patch && leaf_.trim == TrimSide::inside) return true;
        if (on_patch && trim.region.contains(patch_.to_face(inside))) return true;
        return trim.reach > 0 && is_seam(c, uv, trim);
    }

    /// Whether a border's own tolerance reaches as far as the place, given beyond it.
    bool is_seam(Candidate& c, const Vec2& uv, const FaceTrim& trim) const {
        const SurfaceDerivatives s = evaluate(points_, c.uv, 1);
        const Vec2 per_patch = leaf_.domain.extent();
        const Vec2 inside = clamped(uv);
        const Vec2 slope(patch_.map_u.derivative(inside.x), patch_.map_v.derivative(inside.y));
        const Vec2 scale(s.du().length() / std::abs(slope.x * per_patch.x),
                         s.dv().length() / std::abs(slope.y * per_patch.y));
        const auto near = trim.region.nearest_curve(patch_.to_face(uv), scale, trim.reach);
        if (!near) return false;
        const std::uint32_t edge = model_.curves[near->curve].edge;
        if (edge == no_index) return false;
        if (!(near->distance <= std::min(model_.edges[edge].tolerance, model_.join))) return false;
        c.flags = c.flags | HitFlags::seam;
        c.seam = edge;
        return true;
    }

    const TracedModel& model_;
    const PlacedLeaf& placed_;
    const Leaf& leaf_;
    BezierPatchView points_;
    const PatchFrame& patch_;
    const TracedRay& world_;
    PartRay part_;
};

/// World derivatives by patch parameters from local ones by leaf parameters.
SurfaceDerivatives world_derivatives(const SurfaceDerivatives& local, const Leaf& leaf,
                                     const PartPlacement& placement) {
    const Vec2 scale = Vec2(1) / leaf.domain.extent();
    SurfaceDerivatives world;
    double power_u = 1;
    for (std::size_t k = 0; k <= 2; ++k, power_u *= scale.x) {
        double power = power_u;
        for (std::size_t l = 0; k + l <= 2; ++l, power *= scale.y) {
            const Vec3 d = local.d[k][l] * power;
            world.d[k][l] = placement.identity ? d : placement.to_world.vector(d);
        }
    }
    const Vec3 position = leaf.center + local.position();
    world.d[0][0] = placement.identity ? position : placement.to_world.point(position);
    return world;
}

/// The limit normal where there is one, else one across the ray's own leaf.
Vec3 normal_of(const SurfaceDerivatives& s, const Vec2& uv, const BezierPatchView& leaf,
               const PartPlacement& placement) {
    if (const auto normal = steady_normal(s, uv)) return *normal;
    const SurfaceDerivatives middle = evaluate(leaf, Vec2(0.5), 1);
    return placement.to_world.vector(middle.du())
        .cross(placement.to_world.vector(middle.dv()))
        .normalized();
}

/// How far a small step in parameters moves the point: the second order counted twice, which
/// covers what follows it.
double reach_of(const SurfaceDerivatives& s, const Vec2& step) {
    return s.du().length() * step.x + s.dv().length() * step.y +
           s.duu().length() * step.x * step.x + 2 * s.duv().length() * step.x * step.y +
           s.dvv().length() * step.y * step.y;
}

Box2 root_box(const Vec2& uv, const Vec2& error) {
    // Less would be lost in the rounding of the next ray's own start.
    constexpr double least = 1e-9;
    const Vec2 half(std::max(least, 4 * error.x), std::max(least, 4 * error.y));
    return {uv - half, uv + half};
}

} // namespace

bool Candidate::before(const Candidate& other) const {
    return std::tie(t, placed.instance, placed.leaf) <
           std::tie(other.t, other.placed.instance, other.placed.leaf);
}

std::span<const Candidate> leaf_hits(const TracedModel& model, const PlacedLeaf& placed,
                                     const TracedRay& ray, bool clipping_only, double limit) {
    thread_local std::vector<Candidate> found;
    thread_local RootFinder prover(false), clipper(true);
    found.clear();
    LeafTest(model, placed, ray).collect(clipping_only ? clipper : prover, limit, found);
    return found;
}

Hit evaluated(const TracedModel& model, const Candidate& c, bool second_derivatives) {
    const Leaf& leaf = model.leaves.leaves[c.placed.leaf];
    const PartPlacement& placement = model.placements[c.placed.instance];
    const BezierPatchView points = model.leaves.view(leaf);
    const Vec2 extent = leaf.domain.extent();
    const Vec2 beyond = patch_parameters(leaf, c.uv), uv = clamped(beyond);
    const SurfaceDerivatives s =
        world_derivatives(evaluate(points, (uv - leaf.domain.lower) / extent, 2), leaf, placement);

    Hit hit;
    hit.t = c.t;
    hit.instance = c.placed.instance;
    hit.patch = leaf.patch;
    hit.face = model.patches[leaf.patch].face;
    hit.uv = uv;
    hit.position = s.position();
    hit.dpdu = s.du();
    hit.dpdv = s.dv();
    hit.normal = normal_of(s, uv, points, placement);
    if (second_derivatives) hit.second = SecondDerivatives{s.duu(), s.duv(), s.dvv()};
    hit.flags = c.flags;
    if (c.seam != no_index) hit.seam = c.seam;

    const Vec2 off(std::abs(beyond.x - uv.x), std::abs(beyond.y - uv.y));
    const Vec2 error = c.error * extent;
    const double rounding =
        epsilon * (8 * hit.position.length() + 32 * leaf.radius * placement.magnification);
    hit.position_bound =
        reach_of(s, error + off) + leaf.coefficient_error * placement.magnification + rounding;
    hit.root = {hit.instance, hit.patch, root_box(uv, error + off)};
    return hit;
}

} // namespace keiko
