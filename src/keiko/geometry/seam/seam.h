#pragma once

#include "keiko/base/export.h"
#include "keiko/base/job.h"
#include "keiko/geometry/seam/boundary_curves.h"

#include <optional>
#include <vector>

namespace KEIKO_API keiko {

/// Two boundary intervals that stay within the join distance of each other: a place where two faces
/// meet, whether or not the file states it. Both may lie on one face if a closed surface meets
/// itself.
struct Seam {
    BoundaryInterval a, b; ///< run in the same direction in space; a is the earlier in the model
    std::optional<std::uint32_t> edge; ///< the file's shared edge, if both agree on one

    bool operator==(const Seam&) const = default;
};

/// Finds the seams of a model geometrically, including T-junctions, split borders and faces of
/// different files; a file's shared edges are only a hint. A stretch beside two borders belongs to
/// the clearly nearer one, so that the two sides of a sliver do not form a seam. A border with
/// partners within join / 50 all along is searched no further than to their other partners. `join`
/// in mm; a border near the inside of another face is none. The order is that of the borders.
std::vector<Seam> pair_seams(const SurfaceModel& model, double join, const Job& job = {});

} // namespace keiko
