#pragma once

#include "keiko/geometry/seam/seam_candidate.h"
#include "keiko/inspect/seams/seam_partition.h"

namespace keiko {

/// mm: distance within which ends are one vertex of a file. CAD systems write vertices to 1e-5 to
/// 1e-2.
constexpr double same_vertex = 0.01;

/// An end of a piece of a seam, on side a.
struct SeamEnd {
    Vec3 place{0}; ///< world, mm
    Vec3 out{0};   ///< out of the piece, of any length; 0 if the border is stationary there
};

/// One of the two ends of a part.
SeamEnd end_of(const SeamProbe& probe, const SeamPart& part, bool last);

/// True if a line that leaves a piece at one end continues into another piece at the other. Either
/// the ends are one vertex and the line turns no corner there. Or the straight connection between
/// them is at most `reach` mm long and the line turns no corner at either end of it.
bool goes_on(const SeamEnd& from, const SeamEnd& into, double reach);

} // namespace keiko
