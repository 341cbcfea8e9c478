#pragma once

#include "keiko/base/job.h"
#include "keiko/drawing/curves/model_curve.h"
#include "keiko/geometry/seam/seam.h"
#include "keiko/math/interval_set.h"
#include "keiko/visibility/boundaries/boundary_piece.h"

#include <array>
#include <functional>
#include <vector>

namespace keiko {

/// Options of BodyEdges.
struct BodyEdgeOptions {
    double join = 0.5;         ///< mm, within which two borders are a seam
    double crease_angle = 1;   ///< degrees, above which a seam is a crease at its sharpest place
    double chord_error = 0.01; ///< mm, between curves and the chords of their points
};

/// The edges of a body, which no view changes: borders of its faces and creases inside them. A
/// border that two faces share is one curve. Keeps a reference to the model, which its curves read.
class BodyEdges {
public:
    /// Finds all edges. Reports stage "edges". Throws Cancelled.
    BodyEdges(const SurfaceModel& model, const BodyEdgeOptions& options, const Job& job = {});
    BodyEdges(const BodyEdges&) = delete;
    BodyEdges& operator=(const BodyEdges&) = delete;

    /// Curves to be drawn: edges, creases and seams. Without the smooth seams at which a closed
    /// face meets itself.
    const std::vector<ModelCurve>& curves() const { return curves_; }
    /// Borders of every face, and either side of the creases inside: one sheet ends at each.
    const std::vector<OccludingCurve>& occluding() const { return occluding_; }

private:
    void add_seams(const std::vector<Seam>& seams, const Job& job);
    void add_free_edges(const std::vector<Seam>& seams);
    void add_creases_inside();
    void add_occluding(const Job& job);
    /// ModelCurve::sides by the parameter of the surface curve.
    using Sides = std::function<std::array<Vec3, 2>(double)>;
    ModelCurve curve_of(CurveKind kind, const SurfaceCurve& curve, const ParameterInterval& part,
                        const Sides& sides) const;
    Sides sides_of(const Seam& seam) const;
    Sides sides_of(const CreaseLine& line) const;
    OccludingCurve occluding_along(const SurfaceCurve& curve, const PlacedFace& face,
                                   const ParameterInterval& part) const;
    /// The parts of a crease inside a face where the face has material.
    std::vector<ParameterInterval> material_parts(const CreaseLine& line) const;
    bool is_sharp(const CreaseLine& line) const;

    const SurfaceModel& model_;
    BodyEdgeOptions options_;
    BoundaryCurves borders_;
    CreaseLines creases_;
    std::vector<ModelCurve> curves_;
    std::vector<OccludingCurve> occluding_;
};

} // namespace keiko
