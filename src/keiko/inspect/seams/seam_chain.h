#pragma once

#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/geometry/seam/seam.h"
#include "keiko/geometry/seam/seam_candidate.h"
#include "keiko/inspect/seams/seam_partition.h"

#include <array>
#include <span>
#include <vector>

namespace keiko {

/// mm: distance within which ends are one vertex of a file. CAD systems write vertices to 1e-5 to
/// 1e-2.
constexpr double same_vertex = 0.01;

/// An end of a piece of a seam, on side a.
struct SeamEnd {
    Vec3 place{0}; ///< world, mm
    Vec3 out{0};   ///< out of the piece, of any length; 0 if the border is stationary there
    Vec3 run{0};   ///< the same over the length of a vertex, along the border before the end
};

/// The begin and the end of a piece.
std::array<SeamEnd, 2> ends_of(const BoundaryCurves& curves, const Seam& seam);

/// One of the two ends of a part.
SeamEnd end_of(const SeamProbe& probe, const SeamPart& part, bool last);

/// Directions in which side a of a seam runs out of its begin and of its end, over the length at
/// which a step aside by same_vertex is a corner.
std::array<Vec3, 2> runs_out(const BoundaryCurves& curves, const Seam& seam);

/// True if a line that leaves a piece at one end continues into another piece at the other. Either
/// the ends are one vertex and the line turns no corner there, in its place or over the length of a
/// vertex: small teeth are no corners. Or the straight connection between
/// them is at most `reach` mm long and the line turns no corner at either end of it.
bool goes_on(const SeamEnd& from, const SeamEnd& into, double reach);
/// True if any end of one piece continues into any of the other.
bool touch(const std::array<SeamEnd, 2>& a, const std::array<SeamEnd, 2>& b, double reach);

/// Groups seams of the same two placed faces that continue each other (goes_on, within `join` mm).
/// Many p-curve pieces of a file are a single seam to the viewer of the car, while a corner
/// separates two seams, and so does a strip between them. Each chain holds ascending indices into
/// `seams`; chains are ordered by their first.
std::vector<std::vector<std::uint32_t>> seam_chains(const BoundaryCurves& curves,
                                                    std::span<const Seam> seams, double join);

/// Ratio of the widest gap that is followed to the join distance.
constexpr double widest_gap = 10;

/// Seams that end because their gap grows past `join` mm are extended to where the borders part for
/// good. That is where either ends, they diverge by more than parallel_borders, the gap exceeds
/// `widest_gap` times `join`, or another seam begins on one of them. Other seams are unchanged. The
/// distance within which borders are paired thus does not limit the measurement.
std::vector<Seam> widened_seams(const BoundaryCurves& curves, std::span<const Seam> seams,
                                double join);

} // namespace keiko
