#pragma once

#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/openings/free_edges.h"

#include <array>
#include <vector>

namespace keiko {

/// A run of a free edge on the inside of another face, or of any border through a face of another
/// body, which may be a fault or intended.
struct Overlap {
    /// Position of the edge's face relative to the other one.
    enum class Kind {
        lap,     ///< the two faces lie on each other
        tee,     ///< the edge's face stands on the other one
        crossing ///< the edge passes through the other face
    };

    Kind kind = Kind::lap;             ///< of the whole run
    std::array<PlacedFace, 2> sides{}; ///< the face of the edge, and the one that it lies on
    double length = 0;                 ///< mm of the edge
    double length_bound = 0;           ///< mm, error of the length
    double distance = 0;               ///< mm, the largest from the edge to the other face
    double depth = 0;                  ///< mm, the largest from the run to the other face's borders
    double angle = 0;                  ///< degrees between the two faces at the place, 0 to 90
    Vec3 place{0};                     ///< world, mm: where the run is deepest, or a border passes
};

/// Limits beyond which a run counts as an overlap.
struct OverlapLimits {
    double join = 0.5;       ///< mm, within which borders are paired
    double negligible = 0.1; ///< mm, the shortest run that counts
};

/// The overlaps of a model with these free edges, by the face that they lie on and then by edge. A
/// run is the part of an edge that comes within the join distance of the inside of another face,
/// farther than that from its borders, and runs within `parallel_borders` of it. Parts of a run are
/// at most four join distances apart. A run through the other face, from half the join distance on
/// one side to as much on the other, is a crossing of any length.
std::vector<Overlap> find_overlaps(const SurfaceModel& model, const BoundaryCurves& curves,
                                   const FreeEdges& edges, const OverlapLimits& limits,
                                   const Job& job = {});

} // namespace keiko
