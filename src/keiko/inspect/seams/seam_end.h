#pragma once

#include "keiko/geometry/seam/seam_corner.h"
#include "keiko/inspect/seams/seam_partition.h"

namespace keiko {

/// mm: ends as near as this are one vertex of a file. CAD systems write vertices to 1e-5 to 1e-2.
constexpr double same_vertex = 0.01;

/// An end of a piece of a seam, on side a.
struct SeamEnd {
    Vec3 place{0}; ///< world, mm
    Vec3 out{0};   ///< out of the piece, of any length; 0 where the border stands still
};

/// One of the two ends of a part.
SeamEnd end_of(const SeamProbe& probe, const SeamPart& part, bool last);

/// Whether a line that leaves a piece at one end goes on into another piece at the other: where the
/// ends are one vertex and the line turns no corner there, or where the straight way between them
/// is at most `reach` mm long and the line turns no corner at either end of it.
bool goes_on(const SeamEnd& from, const SeamEnd& into, double reach);

} // namespace keiko
