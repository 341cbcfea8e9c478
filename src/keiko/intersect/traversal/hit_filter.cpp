#include "keiko/intersect/traversal/hit_filter.h"

#include "keiko/geometry/bezier/differential_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Share of the sub-patch's radius: no rounding carries a root farther from an end of the ray,
/// whatever the angle.
constexpr double near_end = 1e-3;

/// In widths of a seam: a ray that starts in it may run so far before it gets behind the neighbour.
/// At angles still lower it is some other place.
constexpr double farthest_behind_seam = 2 * seam_depth;

/// The sub-patch of the instance that a root is on; they stand by rising patch.
const SubPatch* sub_patch_of(const TracedModel& model, const Root& root) {
    const PartPlacement& placement = model.placements[root.instance];
    const auto sub_patches = std::span(model.sub_patches.sub_patches)
                                 .subspan(placement.first_sub_patch, placement.sub_patch_count);
    auto found = std::partition_point(
        sub_patches.begin(), sub_patches.end(),
        [&](const SubPatch& sub_patch) { return sub_patch.patch < root.patch; });
    for (; found != sub_patches.end() && found->patch == root.patch; ++found)
        if (found->domain.contains(root.uv.center())) return &*found;
    return nullptr;
}

/// Whether a ray leaves the face at a place of a sub-patch, as the file turns it.
bool leaves_face(const TracedModel& model, const SubPatch& sub_patch, const Vec2& own,
                 const Vec3& direction) {
    const SurfaceDerivatives s = evaluate(model.sub_patches.view(sub_patch), own, 1);
    const double out = model.patches[sub_patch.patch].orientation(sub_patch.patch_parameters(own));
    return out * s.du().cross(s.dv()).dot(direction) > 0;
}

} // namespace

HitFilter::HitFilter(const TracedModel& model, const TracedRay& ray, const PlacedSubPatch& placed)
    : model_(model),
      ray_(ray),
      placed_(placed),
      sub_patch_(model.sub_patches.sub_patches[placed.sub_patch]) {}

bool HitFilter::accepts(Crossing& crossing) const {
    return !is_excluded(crossing) && is_material(crossing);
}

bool HitFilter::meets_excluded_only(double nearest, double farthest) const {
    const std::optional<Root>& root = ray_.ray->excluded;
    if (!root || root->instance != placed_.instance || root->patch != sub_patch_.patch ||
        !sub_patch_.domain.contains(root->uv.lower) || !sub_patch_.domain.contains(root->uv.upper))
        return false;
    const double room = near_end * sub_patch_.radius;
    const auto holds = [&](double s) { return nearest - room <= s && s <= farthest + room; };
    return holds(-ray_.t_start * ray_.speed) || holds(end());
}

bool HitFilter::clear_of_excluded(double nearest, double farthest) const {
    const std::optional<Root>& root = ray_.ray->excluded;
    if (!root) return true;
    if (root->instance == placed_.instance && root->patch == sub_patch_.patch) return false;
    const double reach = model_.faces[model_.patches[sub_patch_.patch].face].reach;
    const double room = 2 * (near_end * sub_patch_.radius + farthest_behind_seam * reach) *
                        model_.placements[placed_.instance].magnification;
    return nearest > room - ray_.t_start * ray_.speed && farthest < end() - room;
}

PartRay HitFilter::part_ray() const {
    return model_.to_part(model_.placements[placed_.instance], ray_.start, ray_.ray->direction,
                          ray_.error);
}

/// Ray parameter of a crossing after one more step of Newton's method. In wide scenes the found one
/// is far from what coordinates say near the ray's ends.
double HitFilter::polished_t(const Crossing& c, const PartRay& part) const {
    const SurfaceDerivatives s = evaluate(model_.sub_patches.view(sub_patch_), c.uv, 1);
    const Vec3 place = part.origin + part.direction * ((c.t - ray_.t_start) * part.speed);
    const Vec3 normal = s.du().cross(s.dv());
    const double step = normal.dot(s.position() - (place - sub_patch_.center)) /
                        (normal.dot(part.direction) * part.speed);
    return std::abs(step) * part.speed <= near_end * sub_patch_.radius ? c.t + step : c.t;
}

/// mm, in the part, to the nearer end of the ray.
double HitFilter::distance_to_end(const Crossing& c, const PartRay& part) const {
    const auto to_end = [&](double t) {
        return std::min(std::abs(t), std::abs(ray_.ray->t_max - t)) * part.speed;
    };
    const double distance = to_end(c.t);
    if (!(distance <= near_end * sub_patch_.radius)) return distance;
    return std::min(distance, to_end(polished_t(c, part)));
}

bool HitFilter::is_excluded(const Crossing& c) const {
    const std::optional<Root>& root = ray_.ray->excluded;
    if (!root) return false;
    if (root->instance != placed_.instance) return is_on_start(c);
    if (root->patch == sub_patch_.patch && root->uv.contains(sub_patch_.patch_parameters(c.uv)))
        return true;
    const PartRay part = part_ray();
    const double distance = distance_to_end(c, part);
    return is_at_end(c, part, distance) || is_behind_own_seam(c, part, distance);
}

bool HitFilter::is_at_end(const Crossing& c, const PartRay& part, double distance) const {
    if (!(distance <= near_end * sub_patch_.radius)) return false;
    return is_within(own_rounding(part), c, distance, part);
}

/// True if a crossing lies on another body that touches the one that the ray starts on: bodies
/// stand on each other, and faces of one are often bodies of their own.
bool HitFilter::is_on_start(const Crossing& c) const {
    const double magnification = model_.placements[placed_.instance].magnification;
    if (!(std::abs(c.t) * ray_.speed <= near_end * sub_patch_.radius * magnification)) return false;
    const PartRay part = part_ray();
    const double distance = std::min(std::abs(c.t), std::abs(polished_t(c, part))) * part.speed;
    const Root& root = *ray_.ray->excluded;
    const SubPatch* start = sub_patch_of(model_, root);
    if (!start) return false;
    const double scale = model_.placements[root.instance].magnification *
                         model_.placements[placed_.instance].reduction;
    const double start_rounding = 64 * epsilon * scale * (start->center.length() + start->radius);
    return is_within(own_rounding(part) + start_rounding, c, distance, part);
}

/// mm, in the part.
double HitFilter::own_rounding(const PartRay& part) const {
    return 64 * epsilon * (part.origin.length() + sub_patch_.center.length() + sub_patch_.radius) +
           4 * part.error;
}

bool HitFilter::is_within(double rounding, const Crossing& c, double distance,
                          const PartRay& part) const {
    if (distance <= rounding) return true; // at whatever angle
    const auto normal = robust_normal(evaluate(model_.sub_patches.view(sub_patch_), c.uv, 2), c.uv);
    const double sine = normal ? std::abs(normal->dot(part.direction)) : 1;
    return distance * sine <= rounding;
}

bool HitFilter::is_behind_own_seam(const Crossing& c, const PartRay& part, double distance) const {
    const PatchFrame& patch = model_.patches[sub_patch_.patch];
    const FaceTrim& trim = model_.faces[patch.face];
    if (!(distance <= farthest_behind_seam * trim.reach)) return false;
    const FaceTrim& own = model_.faces[model_.patches[ray_.ray->excluded->patch].face];
    if (own.region.edges().empty()) return false;
    const NearPlace place = near_place(c, trim, part.direction, own.region.edges());
    if (!place.edge) return false;
    const TrimRegion::NearCurve& border = place.edge->at;
    const SeamGap& gap = model_.seam_gaps[border.curve];
    if (distance > farthest_behind_seam * gap.width ||
        !gap.holds(border.t, place.position - point(border.place), part.direction))
        return false;
    const Root& root = *ray_.ray->excluded;
    const SubPatch* start = sub_patch_of(model_, root);
    if (!start) return false;
    const Vec2 at = (root.uv.center() - start->domain.lower) / start->domain.extent();
    return leaves_face(model_, *start, at, part.direction) ==
           leaves_face(model_, sub_patch_, c.uv, part.direction);
}

/// Place of a root relative to the sub-patch's centre, and the edge whose seam it is near.
HitFilter::NearPlace HitFilter::near_place(const Crossing& c, const FaceTrim& trim,
                                           const Vec3& direction,
                                           std::span<const std::uint32_t> among) const {
    const PatchFrame& patch = model_.patches[sub_patch_.patch];
    const Vec2 uv = sub_patch_.patch_parameters(c.uv), extent = sub_patch_.domain.extent();
    const SurfaceDerivatives s = evaluate(model_.sub_patches.view(sub_patch_), c.uv, 1);
    const ParameterMetric width =
        seam_width(patch, unit_square.nearest(uv), s.du() / extent.x, s.dv() / extent.y, direction);
    return {s.position(), trim.region.nearest_edge(patch.to_face(uv), width, trim.reach, among)};
}

bool HitFilter::is_material(Crossing& c) const {
    const PatchFrame& patch = model_.patches[sub_patch_.patch];
    const FaceTrim& trim = model_.faces[patch.face];
    if (trim.region.untrimmed()) return true;
    const Vec2 uv = sub_patch_.patch_parameters(c.uv), inside = unit_square.nearest(uv);
    const Vec2 allowed = sub_patch_.slip + c.error * sub_patch_.domain.extent();
    const bool on_patch =
        std::abs(uv.x - inside.x) <= allowed.x && std::abs(uv.y - inside.y) <= allowed.y;
    if (on_patch && sub_patch_.trim == TrimSide::inside) return true;
    if (on_patch && trim.region.contains(patch.to_face(inside))) return true;
    return trim.reach > 0 && is_seam(c, uv, trim);
}

/// A first look: no more than some comparisons for rays through windows.
bool HitFilter::may_be_near_edge(const Vec2& uv, const FaceTrim& trim,
                                 const Vec3& direction) const {
    // A ray sees lengths in the surface no shorter than by the sine of its angle to it.
    const double sine = std::abs(sub_patch_.normal.dot(direction)) - sub_patch_.normal_spread;
    const double depth = sine * seam_depth > 1 ? 1 / (sine * seam_depth) : 1;
    const Vec2 reach = sub_patch_.seam_reach * (depth * (1 + 1e-9));
    const PatchFrame& patch = model_.patches[sub_patch_.patch];
    const auto is_affine = [](const ParameterMap& map) {
        return map.kind == ParameterMap::Kind::affine;
    };
    const double widest = is_affine(patch.map_u) && is_affine(patch.map_v) ? 1 : 0.01;
    if (!(reach.x < widest && reach.y < widest)) return true;
    Box2 around;
    around.extend(patch.to_face(uv - reach));
    around.extend(patch.to_face(uv + reach));
    return trim.region.may_be_near_edge(around);
}

/// A place of the face in the part, relative to the sub-patch's centre.
Vec3 HitFilter::point(const Vec2& in_face) const {
    const PatchFrame& patch = model_.patches[sub_patch_.patch];
    const Vec2 uv(patch.map_u.to_patch(in_face.x), patch.map_v.to_patch(in_face.y));
    const Vec2 own = (uv - sub_patch_.domain.lower) / sub_patch_.domain.extent();
    return evaluate(model_.sub_patches.view(sub_patch_), own, 0).position();
}

/// True if a root beyond the border of a closed seam, where only room for rounding is left, belongs
/// to the ray's own start or end. The ray then starts or ends close by, or on the seam's other
/// face, over which that stands out. A ray through the seam from afar meets the other face's own
/// surface.
bool HitFilter::is_lip_of_own(const TrimRegion::NearEdge& near, const SeamGap& gap,
                              double distance) const {
    const std::optional<Root>& root = ray_.ray->excluded;
    if (!root || root->instance != placed_.instance || !gap.samples.empty()) return false;
    if (distance <= farthest_behind_seam * gap.width) return true;
    const std::uint32_t own = model_.patches[root->patch].face;
    if (own == model_.patches[sub_patch_.patch].face) return false;
    const auto edges = model_.faces[own].region.edges();
    return std::binary_search(edges.begin(), edges.end(), near.edge);
}

/// Whether the place, beyond a border, is in the gap to the neighbour's.
bool HitFilter::is_seam(Crossing& c, const Vec2& uv, const FaceTrim& trim) const {
    const PartRay part = part_ray();
    if (!may_be_near_edge(uv, trim, part.direction)) return false;
    const NearPlace place = near_place(c, trim, part.direction);
    if (!place.edge) return false;
    const TrimRegion::NearCurve& border = place.edge->at;
    const Vec3 off = place.position - point(border.place);
    const SeamGap& gap = model_.seam_gaps[border.curve];
    if (!gap.holds(border.t, off, part.direction) ||
        is_lip_of_own(*place.edge, gap, distance_to_end(c, part)))
        return false;
    c.flags = c.flags | HitFlags::seam;
    c.seam = place.edge->edge;
    return true;
}

} // namespace keiko
