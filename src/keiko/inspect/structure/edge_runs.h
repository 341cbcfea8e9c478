#pragma once

#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/seams/model_borders.h"

#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

/// One side of an edge of the file: the border curves that follow each other on it.
struct EdgeSide {
    PlacedFace face;               ///< that it bounds
    std::uint32_t edge = no_index; ///< into SurfaceModel::edges; no_index of a model without edges
    std::vector<BoundaryInterval> curves; ///< at least one
};

/// The sides of all edges, in the order of the borders. What closes a loop without an edge and
/// edges that the file states to be points are left out. Models without edges have a border curve
/// in place of each.
std::vector<EdgeSide> edge_runs(const ModelBorders& borders);

/// Length of the polyline through places of a run, `steps` chords a curve, mm: the run is no
/// shorter.
double polyline_length(const BoundaryCurves& curves, const EdgeSide& run, int steps);

/// Nine places of each of some border curves; world, mm.
std::vector<Vec3> border_places(const BoundaryCurves& curves,
                                std::span<const BoundaryInterval> borders);

} // namespace keiko
