#pragma once

#include "keiko/compare/alignment/boundary_projection.h"
#include "keiko/compare/alignment/closest_point_query.h"
#include "keiko/compare/alignment/convexity.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/intersect/subpatch/sub_patch.h"

#include <array>
#include <optional>
#include <vector>

namespace keiko {

/// The outward unit normal of a face, or 0.
Vec3 outward_normal(const SurfaceDerivatives& s, const Vec2& uv, const Face& face);

/// The axis along which a piece is halved, 0 where it is longer along u: Convexity is proved best
/// for square ones.
unsigned longer_side(const BezierPatchView& piece);

/// What feet are sought on: the faces of a body in pieces that are bent little, by place.
struct ClosestPointQuery::Pieces {
    PlacedModel body;
    std::vector<TrimRegion> trims; ///< a face
    SubPatchSet sub_patches;
    std::vector<Convexity> convex; ///< a leaf
    /// A leaf halved twice by longer_side, the lower halves first: most proofs fail for a leaf and
    /// hold for these.
    std::vector<std::array<Convexity, 4>> quarters;
    std::optional<BoxTree> tree; ///< of the leaves' boxes
    std::optional<BoundaryProjection> borders;

    /// Throws Error for a body without faces, Cancelled.
    Pieces(PlacedModel placed, const Job& job);

    /// Nothing where the leaf is trimmed away.
    std::optional<SurfacePoint> point(std::uint32_t sub_patch, const Vec2& uv) const;
    bool is_material(const SubPatch& sub_patch, const Vec2& uv) const;
    /// The face of a leaf.
    std::uint32_t face(std::uint32_t sub_patch) const {
        return body.model.patches[sub_patches.sub_patches[sub_patch].patch].face;
    }
};

} // namespace keiko
