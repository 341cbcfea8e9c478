#pragma once

#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/seams/model_borders.h"

#include <optional>
#include <vector>

namespace keiko {

/// A place at which the borders of a face cross each other in its parameters.
struct LoopCrossing {
    /// mm: the shorter part of the loop on either side of the crossing. Where two loops cross, the
    /// way along one of them to the nearest other crossing.
    double length = 0;
    bool of_two_loops = false; ///< else of one with itself
    /// Whether they cross is unknown, as it takes too many tests. The length is 0 then.
    bool unknown = false;
    Vec3 place{0}; ///< world, mm
};

/// The loops of one placed face.
using Loops = std::vector<std::vector<BoundaryInterval>>;

/// The crossing of the loops of a placed face that has the largest length, if that is more than
/// `least` mm. Else a place where it is unknown whether they cross; nullopt if there is neither.
/// Curves that touch or lie on each other do not cross.
std::optional<LoopCrossing> loop_crossing(const ModelBorders& borders, const Loops& loops,
                                          double least);

} // namespace keiko
