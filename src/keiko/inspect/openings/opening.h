#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/openings/free_edges.h"

#include <array>
#include <vector>

namespace keiko {

/// A notch, slit or small hole between free edges, which may be a fault of a seam or meant. The
/// sizes of a hole, up to an outline of 300 times the join distance, are those of the narrowest
/// rectangle around it as seen along its normal.
struct Opening {
    std::array<PlacedFace, 2> sides{}; ///< the faces on either side; one face twice in its own slit
    double width = 0;       ///< mm, the largest way from a side to the nearest of the other
    double width_bound = 0; ///< mm, error of the width
    double length = 0;      ///< mm along either side, as far as it was followed
    bool goes_on = false;   ///< beyond that length
    Vec3 place{0};          ///< world, mm: the middle of the way over, or of the hole
};

/// How small openings are.
struct OpeningLimits {
    double join = 0.5; ///< mm, within which borders are paired
    double from = 0.1; ///< mm from the end of a seam, the first way at which its edges are compared
    double gap = 0.01; ///< mm: borders no farther apart are no opening
};

/// The openings between the free edges of a model, each once, in the order of their free edges.
/// There is one
///  - where free edges that go out from the end of a seam enclose a hole in the faces, with an
///    outline of twice the reach at most. The reach is `opening_reach` times the join distance;
///  - where two free edges that go out from one end of a seam come nearer, within the reach, than
///    edges that diverge by `opening_angle`, with no material between them;
///  - where a free edge stays within the join distance of another face's for longer than the
///    wedge at a corner of `parallel_borders` does.
std::vector<Opening> find_openings(const BoundaryCurves& curves, const FreeEdges& edges,
                                   const OpeningLimits& limits, const Job& job = {});

/// Of the join distance, along each free edge from the end of a seam.
constexpr double opening_reach = 50;

} // namespace keiko
