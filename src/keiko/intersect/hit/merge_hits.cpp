#include "keiko/intersect/hit/merge_hits.h"

#include "keiko/intersect/subpatch/traced_model.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <span>

namespace keiko {

namespace {

/// Share of the patch: the sub-patch without its overlaps. These shares tile the patch.
Box2 share(const SubPatch& sub_patch) {
    const Box2 inner{sub_patch.domain.lower + sub_patch.slip,
                     sub_patch.domain.upper - sub_patch.slip};
    return {Vec2(std::max(inner.lower.x, 0.0), std::max(inner.lower.y, 0.0)),
            Vec2(std::min(inner.upper.x, 1.0), std::min(inner.upper.y, 1.0))};
}

} // namespace

BoundaryHit boundary_hit(const TracedModel& model, const Crossing& crossing, Hit hit,
                         const Vec3& direction) {
    // Of a patch: rounding of the shares.
    constexpr double rounding = 1e-15;
    const SubPatch& sub_patch =
        model.sub_patches.sub_patches[model.placed[crossing.sub_patch].sub_patch];
    BoundaryHit result;
    const double facing = model.patches[hit.patch].orientation(hit.uv);
    result.sine = facing * hit.normal.dot(direction) / direction.length();
    result.sub_patch = crossing.sub_patch;
    result.uv = crossing.uv;
    // Clipping ends in boxes without a proof: at a pole many of them stand for one root.
    result.own = !has(crossing.flags, HitFlags::clipped);
    const Box2 own = share(sub_patch);
    const Vec2 uv = sub_patch.patch_parameters(crossing.uv);
    const Vec2 error = crossing.error * sub_patch.domain.extent() + Vec2(rounding);
    for (unsigned k = 0; k < 2; ++k) {
        const double room = error[k] + 2 * sub_patch.slip[k];
        for (const double end : {own.lower[k], own.upper[k]})
            if (!(std::abs(uv[k] - end) > room)) result.at_end = true;
        const bool inside = uv[k] >= own.lower[k] + error[k] && uv[k] <= own.upper[k] - error[k];
        // What goes on past the patch's end is a neighbour's, too.
        if (!inside) result.own = false;
        if (!(uv[k] >= own.lower[k] && uv[k] <= own.upper[k])) result.at_end = true;
        if (!(crossing.uv[k] >= 0 && crossing.uv[k] <= 1)) result.beyond = true;
    }
    result.hit = std::move(hit);
    return result;
}

namespace {

/// Sine of an angle: along rays still lower over a surface it bends away before it is measured.
constexpr double lowest = 0.02;

bool same_sense(const BoundaryHit& a, const BoundaryHit& b) {
    return (a.sine > 0) == (b.sine > 0);
}

double sine(const BoundaryHit& a) {
    return std::max(lowest, std::abs(a.sine));
}

double apart(const BoundaryHit& a, const BoundaryHit& b) {
    return (b.hit.position - a.hit.position).length();
}

double bounds(const BoundaryHit& a, const BoundaryHit& b) {
    return a.hit.position_bound + b.hit.position_bound;
}

class Merger {
public:
    Merger(const TracedModel& model, const Vec3& direction)
        : model_(model), direction_(direction.normalized()) {}

    void add(BoundaryHit next) {
        const auto twin = find_twin(next);
        if (twin == kept_.rend())
            kept_.push_back(std::move(next));
        else
            unite(*twin, std::move(next));
    }

    std::vector<BoundaryHit> take() { return std::move(kept_); }

private:
    std::vector<BoundaryHit>::reverse_iterator find_twin(const BoundaryHit& next) {
        bool other_sense = false;
        for (auto k = kept_.rbegin(); k != kept_.rend(); ++k) {
            if (k->hit.instance != next.hit.instance) continue;
            if (are_copies(*k, next) || (!other_sense && cross_one_seam(*k, next))) return k;
            other_sense = other_sense || !same_sense(*k, next);
        }
        return kept_.rend();
    }

    const SubPatch& sub_patch(const BoundaryHit& a) const {
        return model_.sub_patches.sub_patches[model_.placed[a.sub_patch].sub_patch];
    }
    const FaceTrim& trim(const BoundaryHit& a) const { return model_.faces[a.hit.face]; }

    bool are_copies(const BoundaryHit& a, const BoundaryHit& b) const {
        if (!same_sense(a, b)) return false;
        if (!(apart(a, b) * std::min(sine(a), sine(b)) <= bounds(a, b))) return false;
        if (a.hit.face == b.hit.face) return are_copies_in_face(a, b);
        const auto at_border = [&](const BoundaryHit& x) {
            return x.at_end || sub_patch(x).near_border;
        };
        return at_border(a) && at_border(b);
    }

    bool are_copies_in_face(const BoundaryHit& a, const BoundaryHit& b) const {
        if (a.own && b.own) return false;
        // Sub-patches of different size reach over each other by different lengths: the smaller may
        // hold well inside what is at the end of the larger.
        const bool at_end = (a.at_end || b.at_end) && apart(a, b) <= bounds(a, b);
        const bool ends = at_end || (a.at_end && b.at_end) || a.beyond || b.beyond;
        return ends && (a.sub_patch != b.sub_patch || meet_around(a, b));
    }

    /// Whether one of them ended in a box without a proof.
    static bool clipped(const BoundaryHit& a, const BoundaryHit& b) {
        return has(a.hit.flags, HitFlags::clipped) || has(b.hit.flags, HitFlags::clipped);
    }

    /// On one sub-patch: whether the hits are at opposite ends, which may be closed on each other,
    /// or where clipping could not tell, as on a side that is collapsed into a point.
    static bool meet_around(const BoundaryHit& a, const BoundaryHit& b) {
        constexpr double far = 0.5;
        const Vec2 off = b.uv - a.uv;
        return std::abs(off.x) > far || std::abs(off.y) > far || clipped(a, b);
    }

    bool cross_one_seam(const BoundaryHit& a, const BoundaryHit& b) const {
        if (!same_sense(a, b)) return false;
        // Seams are measured in the part.
        const double away = to_part(a, b.hit.position - a.hit.position).length();
        const double reach = std::max(trim(a).reach, trim(b).reach);
        const double least_sine = std::min(std::abs(a.sine), std::abs(b.sine));
        if (!(away * least_sine <= off_seam(reach, a, b))) return false;
        const auto near_a = near_edge(a), near_b = near_edge(b);
        if (!near_a && !near_b) return false;
        const double off_a = off_surface(a, away), off_b = off_surface(b, away);
        if (near_a && near_b)
            return std::min(off_a, off_b) <=
                   off_seam(std::max(model_.seam_widths[*near_a], model_.seam_widths[*near_b]), a,
                            b);
        return (near_a && off_b <= off_seam(joint_width(a, b), a, b)) ||
               (near_b && off_a <= off_seam(joint_width(b, a), a, b));
    }

    /// How far from the hit's surface the ray is, so far along it from the hit: by the angle, and
    /// by the curvature along the ray.
    double off_surface(const BoundaryHit& a, double away) const {
        const SubPatch& own = sub_patch(a);
        const SurfaceDerivatives s = evaluate(model_.sub_patches.view(own), a.uv, 2);
        // The step in parameters that goes with the ray.
        const double uu = s.du().dot(s.du()), uv = s.du().dot(s.dv()), vv = s.dv().dot(s.dv());
        const Vec3 along = to_part(a, direction_).normalized();
        const double u = s.du().dot(along), v = s.dv().dot(along), det = uu * vv - uv * uv;
        if (!(det > 0)) return away * std::abs(a.sine);
        const Vec2 step((vv * u - uv * v) / det, (uu * v - uv * u) / det);
        const Vec3 bend = s.duu() * (step.x * step.x) + s.duv() * (2 * step.x * step.y) +
                          s.dvv() * (step.y * step.y);
        const double turning = std::abs(bend.dot(s.du().cross(s.dv()).normalized()));
        return away * std::abs(a.sine) + 0.5 * turning * away * away;
    }

    double off_seam(double width, const BoundaryHit& a, const BoundaryHit& b) const {
        return 2 * width + bounds(a, b) * model_.placements[a.hit.instance].reduction;
    }

    Vec3 to_part(const BoundaryHit& a, const Vec3& vector) const {
        return model_.placements[a.hit.instance].to_part.vector(vector);
    }

    /// Width of the seam that the first hit is near, if that may be one with the other's face; or
    /// less than nothing. Beyond its own border a hit stands for any face that the ray may meet
    /// there.
    double joint_width(const BoundaryHit& at, const BoundaryHit& other) const {
        if (at.hit.face == other.hit.face) return -infinity;
        if (at.hit.seam) return model_.seam_widths[*at.hit.seam];
        const auto edge = near_edge(at, trim(other).region.edges());
        return edge ? model_.seam_widths[*edge] : -infinity;
    }

    /// An edge within whose seam the hit is.
    std::optional<std::uint32_t> near_edge(const BoundaryHit& a,
                                           std::span<const std::uint32_t> among = {}) const {
        const FaceTrim& own = trim(a);
        if (!(own.reach > 0) || !sub_patch(a).near_border) return std::nullopt;
        const PatchFrame& patch = model_.patches[a.hit.patch];
        const ParameterMetric width =
            seam_width(patch, a.hit.uv, to_part(a, a.hit.dpdu), to_part(a, a.hit.dpdv),
                       to_part(a, direction_).normalized());
        const auto near = own.region.nearest_edge(patch.to_face(a.hit.uv), width, own.reach, among);
        return near ? std::optional(near->edge) : std::nullopt;
    }

    void unite(BoundaryHit& kept, BoundaryHit next) const {
        const auto seam = [](const BoundaryHit& x) { return has(x.hit.flags, HitFlags::seam); };
        const auto rank = [&](const BoundaryHit& x) { return (seam(x) ? 0 : 2) + x.own; };
        const bool alone = rank(next) != rank(kept);
        const bool steeper = std::abs(next.sine) > 2 * std::abs(kept.sine);
        const bool swap = alone ? rank(next) > rank(kept) : steeper;
        const BoundaryHit& dropped = swap ? kept : next;
        const double cover = apart(kept, next) + dropped.hit.position_bound;
        // Except for a seam hit, the dropped hit may stand for a root of its own beside the
        // other's: where the ray leaves a sharp edge low over the next face, say.
        const bool covers = seam(kept) == seam(next) || has(dropped.hit.flags, HitFlags::clipped);
        const bool undecided = has(dropped.hit.flags, HitFlags::tangential);
        if (swap) kept = std::move(next);
        if (!covers) return;
        kept.hit.position_bound = std::max(kept.hit.position_bound, cover);
        if (undecided) kept.hit.flags = kept.hit.flags | HitFlags::tangential;
    }

    static constexpr double infinity = std::numeric_limits<double>::infinity();

    const TracedModel& model_;
    Vec3 direction_;
    std::vector<BoundaryHit> kept_;
};

} // namespace

std::vector<Hit> merged(std::vector<BoundaryHit> hits, const TracedModel& model,
                        const Vec3& direction) {
    Merger merger(model, direction);
    for (BoundaryHit& next : hits) merger.add(std::move(next));
    std::vector<Hit> result;
    for (BoundaryHit& k : merger.take()) result.push_back(std::move(k.hit));
    std::stable_sort(result.begin(), result.end(),
                     [](const Hit& a, const Hit& b) { return a.t < b.t; });
    return result;
}

} // namespace keiko
