#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/seams/seam_measure.h"

#include <array>
#include <span>
#include <vector>

namespace keiko {

/// A face with a strip that is narrower than the join distance, beside a crease or its run-out. The
/// sides of such a strip are judged one by one, and neither shows how the faces across it continue
/// each other.
struct NarrowFace {
    PlacedFace face;                        ///< the face with the strip
    std::array<PlacedFace, 2> neighbours{}; ///< the faces on either side of the strip at `place`
    double width = 0;                       ///< mm, straight across the strip at `place`
    double step = 0;   ///< mm: the distance of its far side from the tangent plane of the neighbour
                       ///< at its near side, the larger of both ways
    double angle = 0;  ///< degrees by which the neighbours would turn if they met; 180 folded back
    double length = 0; ///< mm of the side along which the face is that narrow
    Vec3 place{0};     ///< world, mm: the middle of the strip where the step is largest
};

/// The faces that have a side of a crease, or of its run-out, within `join` mm of another side of
/// one of their seams, with material between. The sides run nearly parallel there, for longer than
/// the negligible length of the crease. At most one for each placed face, in the order of the
/// model. `pieces`: those of the seams, MeasuredSeams::pieces.
std::vector<NarrowFace> narrow_faces(const ModelBorders& borders,
                                     std::span<const MeasuredSeam> seams,
                                     std::span<const Seam> pieces, double join,
                                     const Job& job = {});

} // namespace keiko
