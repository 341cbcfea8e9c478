#include "keiko/trace/root_check.h"

#include "keiko/trace/seam_width.h"
#include "keiko/trace/steady_normal.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Of the leaf's radius: farther off an end of the ray no rounding carries a root, whatever the
/// angle.
constexpr double near_end = 1e-3;

} // namespace

RootCheck::RootCheck(const TracedModel& model, const TracedRay& ray, const PlacedLeaf& placed)
    : model_(model), ray_(ray), placed_(placed), leaf_(model.leaves.leaves[placed.leaf]) {}

bool RootCheck::passes(Crossing& crossing) const {
    return !is_excluded(crossing) && is_material(crossing);
}

bool RootCheck::meets_excluded_only(double nearest, double farthest) const {
    const std::optional<Root>& root = ray_.ray->excluded;
    if (!root || root->instance != placed_.instance || root->patch != leaf_.patch ||
        !leaf_.domain.contains(root->uv.lower) || !leaf_.domain.contains(root->uv.upper))
        return false;
    const double room = near_end * leaf_.radius;
    const auto holds = [&](double s) { return nearest - room <= s && s <= farthest + room; };
    return holds(-ray_.t_start * ray_.speed) || holds(end());
}

bool RootCheck::clear_of_excluded(double nearest, double farthest) const {
    const std::optional<Root>& root = ray_.ray->excluded;
    if (!root || root->instance != placed_.instance) return true;
    if (root->patch == leaf_.patch) return false;
    const double room =
        2 * near_end * leaf_.radius * model_.placements[placed_.instance].magnification;
    return nearest > room - ray_.t_start * ray_.speed && farthest < end() - room;
}

PartRay RootCheck::part_ray() const {
    return model_.to_part(model_.placements[placed_.instance], ray_.start, ray_.ray->direction,
                          ray_.error);
}

bool RootCheck::is_excluded(const Crossing& c) const {
    const std::optional<Root>& root = ray_.ray->excluded;
    if (!root || root->instance != placed_.instance) return false;
    if (root->patch == leaf_.patch && root->uv.contains(leaf_.patch_parameters(c.uv))) return true;
    const PartRay part = part_ray();
    const double from_start = c.t * part.speed;
    const double from_end = (ray_.ray->t_max - c.t) * part.speed;
    const double distance = std::min(std::abs(from_start), std::abs(from_end));
    if (!(distance <= near_end * leaf_.radius)) return false;
    const auto normal = steady_normal(evaluate(model_.leaves.view(leaf_), c.uv, 2), c.uv);
    const double sine = normal ? std::abs(normal->dot(part.direction)) : 1;
    const double rounding =
        64 * epsilon * (part.origin.length() + leaf_.center.length() + leaf_.radius) +
        4 * part.error;
    return distance * sine <= rounding;
}

bool RootCheck::is_material(Crossing& c) const {
    const PatchFrame& patch = model_.patches[leaf_.patch];
    const FaceTrim& trim = model_.faces[patch.face];
    if (trim.region.untrimmed()) return true;
    const Vec2 uv = leaf_.patch_parameters(c.uv), inside = unit_square.nearest(uv);
    const Vec2 allowed = leaf_.slip + c.error * leaf_.domain.extent();
    const bool on_patch =
        std::abs(uv.x - inside.x) <= allowed.x && std::abs(uv.y - inside.y) <= allowed.y;
    if (on_patch && leaf_.trim == TrimSide::inside) return true;
    if (on_patch && trim.region.contains(patch.to_face(inside))) return true;
    return trim.reach > 0 && is_seam(c, uv, trim);
}

/// A first look for rays through windows: no more than some comparisons.
bool RootCheck::may_be_near_edge(const Vec2& uv, const FaceTrim& trim) const {
    constexpr double widest = 0.01;
    const Vec2& reach = leaf_.seam_reach;
    if (!(reach.x < widest && reach.y < widest)) return true;
    const PatchFrame& patch = model_.patches[leaf_.patch];
    Box2 around;
    around.extend(patch.to_face(uv - reach));
    around.extend(patch.to_face(uv + reach));
    return trim.region.may_be_near_edge(around);
}

/// A place of the face in the part, relative to the leaf's centre.
Vec3 RootCheck::point(const Vec2& in_face) const {
    const PatchFrame& patch = model_.patches[leaf_.patch];
    const Vec2 uv(patch.map_u.to_patch(in_face.x), patch.map_v.to_patch(in_face.y));
    const Vec2 own = (uv - leaf_.domain.lower) / leaf_.domain.extent();
    return evaluate(model_.leaves.view(leaf_), own, 0).position();
}

/// Whether the place, beyond a border, is in the gap to the neighbour's.
bool RootCheck::is_seam(Crossing& c, const Vec2& uv, const FaceTrim& trim) const {
    if (!may_be_near_edge(uv, trim)) return false;
    const SurfaceDerivatives s = evaluate(model_.leaves.view(leaf_), c.uv, 1);
    const PatchFrame& patch = model_.patches[leaf_.patch];
    const PartRay part = part_ray();
    const Vec2 extent = leaf_.domain.extent();
    const ParameterMetric width = seam_width(patch, unit_square.nearest(uv), s.du() / extent.x,
                                             s.dv() / extent.y, part.direction);
    const auto near = trim.region.nearest_edge(patch.to_face(uv), width, trim.reach);
    if (!near) return false;
    const Vec3 off = s.position() - point(near->at.place);
    if (!model_.seam_gaps[near->at.curve].holds(near->at.t, off, part.direction)) return false;
    c.flags = c.flags | HitFlags::seam;
    c.seam = near->edge;
    return true;
}

} // namespace keiko
