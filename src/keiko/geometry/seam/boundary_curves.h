#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/surface_curve.h"

#include <vector>

namespace KEIKO_API keiko {

/// BoundaryInterval::curve of a face without loops is natural_side + 0..3: the four sides of its
/// parameter domain, anticlockwise from v lowest.
constexpr std::uint32_t natural_side = 0xfffffff0;

/// A stretch of one border curve of a placed face.
struct BoundaryInterval {
    std::uint32_t instance = 0, face = 0; ///< into the model's arrays
    std::uint32_t curve = 0;   ///< into SurfaceModel::trim_curves, or natural_side + 0..3
    double begin = 0, end = 1; ///< parameters of that curve; begin > end: run backwards

    bool operator==(const BoundaryInterval&) const = default;
};

/// Every border curve of every placed face of a model, as curves in space: the trim curves, and the
/// four natural sides of faces without loops. Keeps a reference to the model.
class BoundaryCurves {
public:
    /// The borders of a model, to which a reference is kept.
    explicit BoundaryCurves(const SurfaceModel& model);

    /// The border curves of each loop, an interval [0, 1] a curve, instances outer, faces and loops
    /// in file order.
    std::vector<std::vector<BoundaryInterval>> loops() const;
    /// The intervals of all loops.
    std::vector<BoundaryInterval> all() const;
    /// The whole curve that follows that of an interval in its loop, or that precedes it.
    BoundaryInterval beside(const BoundaryInterval& interval, bool after) const;
    /// The curve that an interval runs on.
    SurfaceCurve curve(const BoundaryInterval& interval) const;
    /// mm along a face between two places of its borders, by the straight path in its parameters.
    double way_over_face(const BoundaryInterval& a, double t, const BoundaryInterval& b,
                         double s) const;

private:
    const SurfaceModel* model_;
    std::vector<PatchGrid> grids_;                    ///< a face
    std::vector<bool> material_left_;                 ///< a trim curve
    std::vector<TrimLoop> loops_;                     ///< a trim curve, the loop that it is part of
    std::vector<std::array<Vec3, 8>> natural_points_; ///< four lines a face without loops
    std::vector<std::uint32_t> natural_index_;        ///< a face, into natural_points_
};

} // namespace keiko
