#pragma once

#include <optional>
#include <vector>

#include "keiko/base/job.h"
#include "keiko/patch/surface_model.h"

namespace keiko {

/// A stretch of one trim curve of a placed face.
struct BoundaryInterval {
    std::uint32_t instance = 0, face = 0;
    std::uint32_t curve = 0;   ///< into SurfaceModel::trim_curves
    double begin = 0, end = 1; ///< parameters of that curve; begin > end: run backwards
};

/// Two boundary intervals that stay within the join distance of each other: where two faces meet,
/// whether or not the file says so.
struct Seam {
    BoundaryInterval a, b; ///< run in the same direction in space
    std::optional<std::uint32_t> edge; ///< the file's shared edge, where both agree on one
};

/// Finds the seams of a model geometrically: T-junctions, split borders and faces of different
/// files included; a file's shared edges are only a hint. `join` in mm.
std::vector<Seam> pair_seams(const SurfaceModel& model, double join, const Job& job = {});

} // namespace keiko
