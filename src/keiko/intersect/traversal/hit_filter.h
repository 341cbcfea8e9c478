#pragma once

#include "keiko/intersect/hit/hit.h"
#include "keiko/intersect/kernels/ray_packet.h"
#include "keiko/intersect/subpatch/traced_model.h"

#include <cstdint>
#include <optional>
#include <span>

namespace keiko {

/// Tests that a root on a sub-patch must pass to be a hit of a ray: that no one excluded it, and
/// that there is material. Where the ray excludes a root, roots on its patch inside its box are
/// left out. So are roots on any patch of its instance at either end of the ray where the end is on
/// the surface to within rounding. That keeps a ray that starts on a patch border from hitting the
/// neighbour's copy of the same point. It is measured across the surface, so that a concave surface
/// met again at a low angle still counts. Where the end is near an edge of two faces, roots on the
/// other one that it meets from behind, coming between the two borders, are left out too. An open
/// seam there counts as closed. Where nothing is open (1e-7 of the part's size), so is what the
/// other face has beyond its border for the sake of rounding. Faces that the file turns against
/// each other are not considered.
class HitFilter {
public:
    /// Filter of roots of one ray on one placed sub-patch; keeps references to all three.
    HitFilter(const TracedModel& model, const TracedRay& ray, const PlacedSubPatch& placed);

    /// Whether the crossing counts; marks seam hits.
    bool accepts(Crossing& crossing) const;
    /// True if a ray that meets the sub-patch at most once, between these distances from its start,
    /// meets only the root that it excludes, which lies at one of its ends.
    bool meets_excluded_only(double nearest, double farthest) const;
    /// Whether no root between these distances from the start can be an excluded one.
    bool clear_of_excluded(double nearest, double farthest) const;

private:
    /// mm from the start to where t is at its largest.
    double end() const { return (ray_.ray->t_max - ray_.t_start) * ray_.speed; }
    PartRay part_ray() const;
    Vec3 point(const Vec2& in_face) const;
    double own_rounding(const PartRay& part) const;
    double polished_t(const Crossing& crossing, const PartRay& part) const;
    double distance_to_end(const Crossing& crossing, const PartRay& part) const;
    bool is_excluded(const Crossing& crossing) const;
    bool is_at_end(const Crossing& crossing, const PartRay& part, double distance) const;
    bool is_on_start(const Crossing& crossing) const;
    /// Whether a crossing so far from an end of the ray is at it to within `rounding` mm.
    bool is_within(double rounding, const Crossing& crossing, double distance,
                   const PartRay& part) const;
    bool is_behind_own_seam(const Crossing& crossing, const PartRay& part, double distance) const;
    struct NearPlace {
        Vec3 position{0};
        std::optional<TrimRegion::NearEdge> edge;
    };
    NearPlace near_place(const Crossing& crossing, const FaceTrim& trim, const Vec3& direction,
                         std::span<const std::uint32_t> among = {}) const;
    bool is_material(Crossing& crossing) const;
    bool may_be_near_edge(const Vec2& uv, const FaceTrim& trim, const Vec3& direction) const;
    bool is_lip_of_own(const TrimRegion::NearEdge& near, const SeamGap& gap, double distance) const;
    bool is_seam(Crossing& crossing, const Vec2& uv, const FaceTrim& trim) const;

    const TracedModel& model_;
    const TracedRay& ray_;
    const PlacedSubPatch& placed_;
    const SubPatch& sub_patch_;
};

} // namespace keiko
