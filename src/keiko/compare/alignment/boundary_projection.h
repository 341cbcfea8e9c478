#pragma once

#include "keiko/geometry/bvh/box_tree.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/model/curve_polyline.h"
#include "keiko/geometry/seam/boundary_curves.h"

#include <functional>
#include <optional>
#include <vector>

namespace keiko {

/// The point of a body's borders that is nearest to a given point.
struct ProjectedBoundaryPoint {
    std::uint32_t border = 0; ///< into BoundaryProjection::borders
    double t = 0;
    Vec3 position{0};
    double distance = 0; ///< mm
};

/// Finds the nearest points of all borders of the faces of a model, seams included: chords of their
/// polylines are tried by distance, and Newton's iteration ends on the exact curve. Looks into the
/// model it was made from.
class BoundaryProjection {
public:
    explicit BoundaryProjection(const SurfaceModel& model);

    /// On the borders of the faces that `counts` accepts, or of all where it is empty; nothing
    /// where none is within `radius` mm.
    std::optional<ProjectedBoundaryPoint> foot(
        const Vec3& p, double radius,
        const std::function<bool(std::uint32_t face)>& counts = {}) const;
    const std::vector<BoundaryInterval>& borders() const { return borders_; }
    SurfaceCurve curve(std::uint32_t border) const { return curves_.curve(borders_[border]); }
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

} // namespace keiko
