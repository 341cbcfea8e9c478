#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/visibility/nets/affine_bounds.h"
#include "keiko/visibility/nets/degree_reduced_net.h"
#include "keiko/visibility/nets/scalar_net.h"
#include "keiko/visibility/silhouettes/chord_elevation.h"

#include <vector>

namespace keiko {

/// A placed patch, or a part of one, as an occluder: its points and its tangent planes, relative
/// to `center`, world, mm.
struct OccluderPatch {
    std::uint32_t instance = 0, face = 0, patch = 0; ///< into the model's arrays
    Box2 uv{Vec2(0), Vec2(1)};                       ///< of the model's patch that this one covers
    Vec3 center{0};                                  ///< world, mm
    double size = 0;                                 ///< mm, of its box
    HomogeneousNet points;                           ///< control points in world axes
    HomogeneousNet planes;                           ///< tangent_planes() of them
    bool rational = false;                           ///< the weights differ
    bool flat = false;                               ///< has no folds
    ParameterMap map_u, map_v; ///< between the parameters of the model's patch and its face

    /// Parameters of the model's patch for a place of this one's own [0, 1]^2.
    Vec2 patch_parameters(const Vec2& own) const { return uv.lower + uv.extent() * own; }
    /// Face parameters for a place of this one's own [0, 1]^2.
    Vec2 face_parameters(const Vec2& own) const {
        const Vec2 p = patch_parameters(own);
        return {map_u.to_face(p.x), map_v.to_face(p.y)};
    }
};

/// A part of an occluder patch over which points and tangent planes are nearly affine, so that a
/// few products tell whether a viewpoint can see it edge-on, and where a plane cuts that
/// silhouette.
struct SilhouettePiece {
    std::uint32_t patch = 0; ///< into Silhouettes::patches
    Box2 uv;                 ///< of that patch
    bool trimmed = false;    ///< trim curves may cross it
    Box3 box;                ///< world, mm
    /// Axes of the nets. The last axis is about the normal: where the surface is edge-on, a
    /// viewpoint has little of that, and bounds of what varies along the normal weigh little.
    NetFrame frame;
    AffineNet points;                 ///< homogeneous points over `uv`, in the frame
    AffineNet planes;                 ///< tangent planes over `uv`, in the frame
    HomogeneousNet overlapped_points; ///< over the piece and its overlap
    DegreeReducedNet lowered_planes;  ///< over the same
    TangentBounds chords; ///< of `points`, for viewpoints whose foot is in surroundings()
    /// Half angle of the cone about the last axis that holds all normals, rad.
    double normal_angle = 4;

    /// The piece's share of its patch with what it overlaps its neighbours by, so that no event
    /// falls between them.
    Box2 overlapped() const {
        constexpr double overlap = 1e-7;
        return {uv.lower - uv.extent() * overlap, uv.upper + uv.extent() * overlap};
    }
    /// The piece and half of its extent around: chords from a viewpoint whose foot lies there to
    /// the piece are mixtures of derivatives over this part of the patch.
    Box2 surroundings() const { return {uv.lower - uv.extent() / 2, uv.upper + uv.extent() / 2}; }
    /// Weights that turn `planes` into the function that is zero where `viewpoint` sees the piece
    /// edge-on.
    Vec4 weights(const Viewpoint& viewpoint) const {
        return frame.local(viewpoint.seen_from(frame.center));
    }
};

/// Everything of a model that a viewpoint may see edge-on.
struct Silhouettes {
    std::vector<OccluderPatch> patches;  ///< by instance, then by patch
    std::vector<SilhouettePiece> pieces; ///< by patch; none of flat patches
    std::vector<TrimRegion> regions;     ///< one a face of the model

    /// Unit normal of either sense at a place of a placed patch; nothing where it has none.
    std::optional<Vec3> normal_at(const Root& root) const;
};

/// Silhouettes of all placed patches of a model. Patches of higher degree than max_occluder_degree
/// are approximated by pieces of that degree, to
/// 1e-11 of their size. Throws Cancelled.
Silhouettes silhouettes_of(const SurfaceModel& model, const Job& job);

} // namespace keiko
