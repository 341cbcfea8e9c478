#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/bezier/parameter_metric.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/geometry/seam/seam_gap.h"
#include "keiko/intersect/roots/planar_net.h"
#include "keiko/intersect/subpatch/packed_sub_patch.h"
#include "keiko/intersect/subpatch/sub_patch.h"

#include <optional>
#include <vector>

namespace keiko {

/// A ray in the coordinates of a part, made ready for its sub-patches.
struct PartRay {
    Vec3 origin{0};                ///< mm
    Vec3 direction{0};             ///< unit
    Vec3 normal_f{0}, normal_g{0}; ///< of the two planes through the ray; unit, orthogonal
    double speed = 1;              ///< mm of the part in one unit of the world ray's t
    double error = 0;              ///< mm, bound of the distance to the exact ray at the origin
    double turn = 0; ///< radians, bound of the direction's error beyond that of being unit
};

/// `error`: by how much the given origin may miss the exact ray, mm.
PartRay part_ray(const Vec3& origin, const Vec3& direction, double error);

/// A sub-patch as a part ray sees it.
struct RayProjection {
    PlanarNet net; ///< weighted distances of the control points from the ray's two planes, mm
    double slack;  ///< bound of the error of a coefficient of `net`
    double foot;   ///< mm along the ray from its origin to its point nearest SubPatch::center
};

/// False when the ray stays clear of the ball around the sub-patch.
bool near_sub_patch(const PartRay& ray, const SubPatch& sub_patch);

/// A sub-patch as a ray sees it. `points` are its control points relative to its centre, as
/// SubPatchSet::view() returns them.
RayProjection project_ray(const PartRay& ray, const SubPatch& sub_patch,
                          const BezierPatchView& points);

/// A sub-patch of a placed part: what the box hierarchy is built of.
struct PlacedSubPatch {
    std::uint32_t instance = 0;  ///< index into TracedModel::placements
    std::uint32_t sub_patch = 0; ///< index into SubPatchSet::sub_patches
};

/// Placement of a part in the world.
struct PartPlacement {
    Affine to_world;                         ///< the instance's transform
    Affine to_part;                          ///< its inverse, to within `inverse_error`
    bool identity = true;                    ///< the part's coordinates are the world's
    double magnification = 1, reduction = 1; ///< bounds of a length's stretch, and of its inverse
    double inverse_error = 0; ///< bound of how far to_part after to_world is from the identity
    std::uint32_t first_sub_patch = 0; ///< of the part, into SubPatchSet::sub_patches
    std::uint32_t sub_patch_count = 0; ///< of the part
};

/// A patch's way to its face's parameters.
struct PatchFrame {
    std::uint32_t face = 0;    ///< index into the model's faces
    ParameterMap map_u, map_v; ///< between patch and face parameters
    bool reversed = false;     ///< as Face::reversed

    /// Face parameters of a place of the patch.
    Vec2 to_face(const Vec2& uv) const { return {map_u.to_face(uv.x), map_v.to_face(uv.y)}; }
    /// 1 where the face's own outward normal is along dpdu x dpdv, -1 where it is against it.
    double orientation(const Vec2& uv) const {
        const double turned = map_u.derivative(uv.x) * map_v.derivative(uv.y);
        return (turned < 0) == reversed ? 1 : -1;
    }
};

/// The trim curves of one face.
struct FaceTrim {
    TrimRegion region; ///< what the trim loops leave of the face
    double reach = 0;  ///< mm, the widest seam of its borders
};

/// All that the tracer keeps of a SurfaceModel.
struct TracedModel {
    SubPatchSet sub_patches;               ///< of all parts; without frames and roundings
    std::vector<PatchFrame> patches;       ///< by patch
    std::vector<FaceTrim> faces;           ///< by face
    std::vector<SeamGap> seam_gaps;        ///< by trim curve
    std::vector<double> seam_widths;       ///< by edge, the widest of its curves, mm
    std::vector<PartPlacement> placements; ///< by instance
    std::vector<PlacedSubPatch> placed;    ///< by instance, then by sub-patch
    std::vector<PackedSubPatch> hot;       ///< one for each of `placed`

    /// The ray seen from a placement. `origin` is any point of it; `error` as in part_ray, world.
    PartRay to_part(const PartPlacement& placement, const Vec3& origin, const Vec3& direction,
                    double error) const;
    /// World box of a placed sub-patch's control points, mm.
    Box3 bounds(const PlacedSubPatch& at) const;
    /// Size of the arrays, roughly.
    std::size_t bytes() const;
};

/// Splits and classifies every face, in parallel; reports stage "build". `join` and `flat_enough`
/// as TracerOptions has them. Throws Cancelled.
TracedModel traced_model(const SurfaceModel& model, double join, double flat_enough,
                         const Job& job);

/// Factor by which lengths along the ray are shortened when the distance of a root to a border is
/// measured. A seam's width says how far the neighbour's border may be in space. A ray that passes
/// the border within it may meet the surface much farther away, in the ratio of the sine of its
/// angle to the surface. So the distance is measured as the ray sees it.
constexpr double seam_depth = 16;

/// The metric of a patch's face parameters at `uv` for a ray: from the tangents by the patch's
/// parameters and the ray's unit direction, all in the part's coordinates.
inline ParameterMetric seam_width(const PatchFrame& patch, const Vec2& uv, const Vec3& du,
                                  const Vec3& dv, const Vec3& direction) {
    const auto seen = [&](const Vec3& tangent) {
        return tangent - direction * (direction.dot(tangent) * (1 - 1 / seam_depth));
    };
    return {seen(du) / patch.map_u.derivative(uv.x), seen(dv) / patch.map_v.derivative(uv.y)};
}

} // namespace keiko
