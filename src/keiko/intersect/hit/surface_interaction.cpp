#include "keiko/intersect/hit/surface_interaction.h"

#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/bezier/subpatch.h"
#include "keiko/intersect/kernels/prefetch.h"

#include <algorithm>
#include <cmath>

namespace keiko {

namespace {

Vec3 spatial(const Component4& c) {
    return {c[0], c[1], c[2]};
}

} // namespace

SurfaceDerivatives SurfaceJet::derivatives() const {
    SurfaceDerivatives s;
    s.d[0][0] = position;
    s.d[1][0] = du;
    s.d[0][1] = dv;
    s.d[2][0] = duu;
    s.d[1][1] = duv;
    s.d[0][2] = dvv;
    return s;
}

SurfaceJet projected(const HomogeneousJet& jet, bool rational) {
    const double scale = 1 / jet.value[3];
    SurfaceJet s{spatial(jet.value) * scale, spatial(jet.du) * scale,  spatial(jet.dv) * scale,
                 spatial(jet.duu) * scale,   spatial(jet.duv) * scale, spatial(jet.dvv) * scale};
    if (!rational) return s;
    const double wu = jet.du[3] * scale, wv = jet.dv[3] * scale;
    s.du -= s.position * wu;
    s.dv -= s.position * wv;
    s.duu -= s.du * (2 * wu) + s.position * (jet.duu[3] * scale);
    s.dvv -= s.dv * (2 * wv) + s.position * (jet.dvv[3] * scale);
    s.duv -= s.dv * wu + s.du * wv + s.position * (jet.duv[3] * scale);
    return s;
}

std::optional<Vec3> bending_side(const SurfaceJet& j, const Vec3& way) {
    const Vec3 n = j.du.cross(j.dv);
    const double e = j.du.dot(j.du), f = j.du.dot(j.dv), g = j.dv.dot(j.dv);
    const double u = j.du.dot(way), v = j.dv.dot(way), d = e * g - f * f;
    const double a = (g * u - f * v) / d, b = (e * v - f * u) / d;
    const Vec3 second = j.duu * (a * a) + j.duv * (2 * a * b) + j.dvv * (b * b);
    constexpr double sure = 1e-5;
    const double bend = n.dot(second) / n.length();
    if (!(std::abs(bend) > sure * second.length())) return std::nullopt;
    return n * ((bend > 0 ? 1 : -1) / n.length());
}

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// Normal where tangents alone do not determine it: its limit if there is one, else one across the
/// ray's own sub-patch.
Vec3 limit_normal(const SurfaceJet& s, const Vec2& uv, const BezierPatchView& sub_patch,
                  const PartPlacement& placement) {
    if (const auto normal = robust_normal(s.derivatives(), uv)) return *normal;
    const SurfaceDerivatives middle = evaluate(sub_patch, Vec2(0.5), 1);
    return placement.to_world.vector(middle.du())
        .cross(placement.to_world.vector(middle.dv()))
        .normalized();
}

SurfaceJet jet_of(const HitPacket& hits, std::size_t lane) {
    return {HitPacket::at(hits.position, lane), HitPacket::at(hits.du, lane),
            HitPacket::at(hits.dv, lane),       HitPacket::at(hits.duu, lane),
            HitPacket::at(hits.duv, lane),      HitPacket::at(hits.dvv, lane)};
}

/// Size of a box in a sub-patch's parameters above which derivatives at its middle do not bound how
/// far the surface goes. In smaller ones the terms beyond second order are below rounding.
constexpr double widest_for_derivatives = 1e-6;

/// Bound of how far the surface goes from the place in the middle of a box of the sub-patch's own
/// parameters, by the box's control points; mm of the world.
double reach_in_box(const BezierPatchView& sub_patch, const Vec2& middle, const Vec2& half,
                    const Affine& to_world) {
    const Vec3 place = evaluate(sub_patch, middle, 0).position();
    // At a pole the box may be as wide as the sub-patch: beyond that the weights run down to zero.
    const Box2 box =
        unit_square.padded(widest_for_derivatives).intersection({middle - half, middle + half});
    double reach = 0;
    for (const Vec4& p : subpatch(sub_patch, box)) {
        if (!(p.w > 0)) return std::numeric_limits<double>::infinity();
        const Vec3 away = to_world.vector(euclidean(p) - place);
        reach = std::max(reach, away.length());
    }
    return reach;
}

Box2 root_box(const Vec2& uv, const Vec2& error) {
    // Less would be lost in the rounding of the next ray's own start.
    constexpr double least = 1e-9;
    const Vec2 half(std::max(least, 4 * error.x), std::max(least, 4 * error.y));
    return {uv - half, uv + half};
}

} // namespace

void SurfaceInteraction::announce(const TracedModel& model, std::uint32_t sub_patch) {
    const SubPatchSet& sub_patches = model.sub_patches;
    const PackedSubPatch& hot = model.hot[sub_patch];
    prefetch(std::span(&sub_patches.sub_patches[model.placed[sub_patch].sub_patch], 1));
    prefetch(std::span(&sub_patches.points[hot.polynomial], hot.coefficients()));
}

void SurfaceInteraction::announce(const Crossing& crossing) {
    if (crossing.sub_patch == announced_) return;
    announced_ = crossing.sub_patch;
    announce(model_, crossing.sub_patch);
}

void SurfaceInteraction::add(const Crossing& crossing, Hit& hit) {
    Group& group = by_sub_patch_[crossing.sub_patch % by_sub_patch_.size()];
    if (group.count > 0 && group.crossings[0]->sub_patch != crossing.sub_patch) mix(group);
    group.add(&crossing, &hit);
    if (group.full()) evaluate(group);
}

void SurfaceInteraction::finish() {
    for (Group& group : by_sub_patch_) mix(group);
    evaluate(mixed_);
}

void SurfaceInteraction::mix(Group& group) {
    for (std::size_t i = 0; i < group.count; ++i) {
        mixed_.add(group.crossings[i], group.hits[i]);
        if (mixed_.full()) evaluate(mixed_);
    }
    group.count = 0;
}

void SurfaceInteraction::evaluate(Group& group) {
    if (group.count == 0) return;
    block_.count = group.count;
    for (std::size_t lane = 0; lane < group.count; ++lane) ask(*group.crossings[lane], lane);
    kernels_.evaluate_hits(block_);
    for (std::size_t lane = 0; lane < group.count; ++lane)
        write(*group.crossings[lane], lane, *group.hits[lane]);
    group.count = 0;
}

void SurfaceInteraction::ask(const Crossing& c, std::size_t lane) {
    const PlacedSubPatch& placed = model_.placed[c.sub_patch];
    const SubPatch& sub_patch = model_.sub_patches.sub_patches[placed.sub_patch];
    const PartPlacement& placement = model_.placements[placed.instance];
    const Vec2 extent = sub_patch.domain.extent();
    const Vec2 beyond = sub_patch.patch_parameters(c.uv);
    const Vec2 per = Vec2(1) / extent;
    const Vec2 uv = unit_square.nearest(beyond), local = (uv - sub_patch.domain.lower) * per;
    const Vec2 off(std::abs(beyond.x - uv.x), std::abs(beyond.y - uv.y));
    const Vec2 error = c.error * extent + off;
    BezierPatchView& view = block_.sub_patch[lane];
    view.degree_u = sub_patch.degree_u, view.degree_v = sub_patch.degree_v;
    view.points = std::span(model_.sub_patches.points)
                      .subspan(sub_patch.first_point, model_.hot[c.sub_patch].coefficients());
    block_.weight[lane] = model_.hot[c.sub_patch].rational ? 0 : view.points.front().w;
    block_.u[lane] = local.x, block_.v[lane] = local.y;
    block_.per_u[lane] = per.x, block_.per_v[lane] = per.y;
    for (unsigned k = 0; k < 3; ++k) block_.center[k][lane] = sub_patch.center[k];
    block_.to_world[lane] = placement.identity ? nullptr : &placement.to_world;
    block_.error_u[lane] = error.x, block_.error_v[lane] = error.y;
}

void SurfaceInteraction::write_whole(const Crossing& crossing, Hit& hit) {
    block_.count = 1;
    ask(crossing, 0);
    kernels_.evaluate_hits(block_);
    write(crossing, 0, hit);
}

void SurfaceInteraction::write_face(const Crossing& c, Hit& hit) const {
    const PlacedSubPatch& placed = model_.placed[c.sub_patch];
    hit.t = c.t;
    hit.flags = c.flags;
    if (c.seam != no_index) hit.seam = c.seam;
    hit.instance = placed.instance;
    hit.patch = model_.sub_patches.sub_patches[placed.sub_patch].patch;
    hit.face = model_.patches[hit.patch].face;
}

void SurfaceInteraction::write(const Crossing& c, std::size_t lane, Hit& hit) const {
    const PlacedSubPatch& placed = model_.placed[c.sub_patch];
    const SubPatch& sub_patch = model_.sub_patches.sub_patches[placed.sub_patch];
    const PartPlacement& placement = model_.placements[placed.instance];
    write_face(c, hit);
    hit.uv = unit_square.nearest(sub_patch.patch_parameters(c.uv));
    hit.root = {hit.instance, hit.patch,
                root_box(hit.uv, Vec2(block_.error_u[lane], block_.error_v[lane]))};
    write_surface(lane, placement, hit);
    hit.position_bound = position_bound(lane, sub_patch, placement);
}

void SurfaceInteraction::write_surface(std::size_t lane, const PartPlacement& placement,
                                       Hit& hit) const {
    // Straight from the block: copies of copies would wait for each other.
    hit.position = HitPacket::at(block_.position, lane);
    hit.dpdu = HitPacket::at(block_.du, lane);
    hit.dpdv = HitPacket::at(block_.dv, lane);
    hit.normal = HitPacket::at(block_.normal, lane);
    const bool plain = (block_.plain >> lane & 1) != 0;
    if (!plain)
        hit.normal = limit_normal(jet_of(block_, lane), hit.uv, block_.sub_patch[lane], placement);
    if (!second_derivatives_) return;
    SecondDerivatives& second = hit.second.emplace();
    second.duu = HitPacket::at(block_.duu, lane);
    second.duv = HitPacket::at(block_.duv, lane);
    second.dvv = HitPacket::at(block_.dvv, lane);
}

double SurfaceInteraction::position_bound(std::size_t lane, const SubPatch& sub_patch,
                                          const PartPlacement& placement) const {
    const Vec2 error(block_.error_u[lane], block_.error_v[lane]),
        extent = sub_patch.domain.extent();
    const Vec2 widest = extent * widest_for_derivatives;
    double reach = block_.reach[lane];
    if (error.x > widest.x || error.y > widest.y)
        reach = reach_in_box(block_.sub_patch[lane], {block_.u[lane], block_.v[lane]},
                             error / extent, placement.to_world);
    const double steps = 8 + 4.0 * (sub_patch.degree_u + sub_patch.degree_v);
    const double moved = placement.identity ? 0 : placement.to_world.translation.length();
    const double away = block_.away[lane] + moved;
    const double rounding =
        epsilon * (8 * away + steps * sub_patch.radius * placement.magnification);
    return reach + sub_patch.coefficient_error * placement.magnification + rounding;
}

Hit evaluated(const TracedModel& model, const SubPatchKernels& kernels, const Crossing& crossing,
              bool second_derivatives) {
    Hit hit;
    SurfaceInteraction(model, kernels, second_derivatives).write_whole(crossing, hit);
    return hit;
}

} // namespace keiko
