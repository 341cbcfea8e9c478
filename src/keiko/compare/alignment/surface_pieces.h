#pragma once

#include "keiko/compare/alignment/closest_point_query.h"
#include "keiko/compare/alignment/piece_bounds.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/intersect/subpatch/sub_patch.h"

#include <functional>
#include <optional>
#include <vector>

namespace keiko {

/// The point of a body's borders that is nearest to a given point.
struct ProjectedBoundaryPoint {
    std::uint32_t border = 0; ///< into BoundaryProjection::borders
    double t = 0;             ///< parameter of the border's curve
    Vec3 position{0};         ///< world, mm
    double distance = 0;      ///< mm
};

/// Finds the nearest points of all borders of the faces of a model, seams included: chords of their
/// polylines are tried by distance, and Newton's iteration ends on the exact curve. Looks into the
/// model it was made from.
class BoundaryProjection {
public:
    /// Makes the polylines of all borders, to within 0.05 mm.
    explicit BoundaryProjection(const SurfaceModel& model);

    /// On the borders of the faces that `counts` accepts, or of all where it is empty; nothing
    /// where none is within `radius` mm.
    std::optional<ProjectedBoundaryPoint> foot(
        const Vec3& p, double radius,
        const std::function<bool(std::uint32_t face)>& counts = {}) const;
    /// All borders of the placed faces.
    const std::vector<BoundaryInterval>& borders() const { return borders_; }
    /// Exact curve of a border.
    SurfaceCurve curve(std::uint32_t border) const { return curves_.curve(borders_[border]); }
    /// Polyline of a border.
    const CurvePolyline& polyline(std::uint32_t border) const { return polylines_[border]; }

private:
    struct Chord {
        std::uint32_t border = 0, first = 0;
    };

    BoundaryCurves curves_;
    std::vector<BoundaryInterval> borders_;
    std::vector<CurvePolyline> polylines_;
    std::vector<Chord> chords_;
    std::optional<BoxTree> tree_;
};

/// The outward unit normal of a face, or 0.
Vec3 outward_normal(const SurfaceDerivatives& s, const Vec2& uv, const Face& face);

/// The axis along which a piece is halved, 0 where it is longer along u: bounds are tightest for
/// square ones.
unsigned longer_side(const BezierPatchView& piece);

/// Faces of a body in pieces that are bent little, by place, as searched for nearest points.
struct ClosestPointQuery::Pieces {
    PlacedModel body;                          ///< the body
    std::vector<TrimRegion> trims;             ///< a face
    SubPatchSet sub_patches;                   ///< the pieces
    std::vector<PieceBounds> bounds;           ///< of each piece
    std::optional<BoxTree> tree;               ///< of the pieces' boxes
    std::optional<BoundaryProjection> borders; ///< of all faces of the body

    /// Throws Error for a body without faces, Cancelled.
    Pieces(PlacedModel placed, const Job& job);

    /// Point of a leaf; nullopt where the leaf is trimmed away.
    std::optional<SurfacePoint> point(std::uint32_t sub_patch, const Vec2& uv) const;
    /// True if a place of a leaf, by the leaf's own parameters, is not trimmed away.
    bool is_material(const SubPatch& sub_patch, const Vec2& uv) const;
    /// The face of a leaf.
    std::uint32_t face(std::uint32_t sub_patch) const {
        return body.model.patches[sub_patches.sub_patches[sub_patch].patch].face;
    }
};

} // namespace keiko
