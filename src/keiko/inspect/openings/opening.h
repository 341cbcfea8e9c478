#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/openings/free_edges.h"

#include <array>
#include <vector>

namespace keiko {

/// A notch, slit or small hole between free edges, which may be a fault of a seam or intended. The
/// sizes of a hole, up to an outline of 300 times the join distance, are those of the narrowest
/// rectangle around it viewed along its normal.
struct Opening {
    std::array<PlacedFace, 2> sides{}; ///< the faces on either side; one face twice in its own slit
    double width = 0;       ///< mm, the largest distance from a side to the nearest place of the
                            ///< other
    double width_bound = 0; ///< mm, error of the width
    double length = 0;      ///< mm along either side, as far as it was followed
    bool goes_on = false;   ///< it continues beyond that length
    Vec3 place{0};          ///< world, mm: the middle of the gap, or of the hole
};

/// Limits of the sizes of openings.
struct OpeningLimits {
    double join = 0.5; ///< mm, within which borders are paired
    double from = 0.1; ///< mm from the end of a seam, the first distance at which its edges are
                       ///< compared
    double gap = 0.01; ///< mm: borders within this distance form no opening
};

/// The openings between the free edges of a model, each once, in the order of their free edges.
/// Three configurations are openings:
/// - Free edges that go out from the end of a seam enclose a hole in the faces, with an outline of
///   at most twice the reach. The reach is `opening_reach` times the join distance.
/// - Two free edges that go out from one end of a seam come nearer, within the reach, than edges
///   that diverge by `opening_angle`. No material lies between them.
/// - A free edge stays within the join distance of another face's. It does so for longer than the
///   wedge at a corner of `parallel_borders`.
std::vector<Opening> find_openings(const BoundaryCurves& curves, const FreeEdges& edges,
                                   const OpeningLimits& limits, const Job& job = {});

/// Distance along each free edge from the end of a seam, in join distances.
constexpr double opening_reach = 50;

} // namespace keiko
