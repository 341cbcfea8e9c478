#pragma once

#include "keiko/visibility/boundaries/border_piece.h"
#include "keiko/visibility/query/occluders.h"
#include "keiko/visibility/silhouettes/piece_tree.h"
#include "keiko/visibility/silhouettes/silhouette_events.h"

namespace keiko {

/// All that Occluders know of a model.
struct Occluders::Scene {
    Silhouettes silhouettes;
    std::vector<BorderPiece> borders;
    PieceTree silhouette_pieces, border_pieces, surface;
    LeafKernels kernels = leaf_kernels();
    CandidateMaker candidates{silhouettes, kernels};
    SilhouetteSolver solver{silhouettes, kernels};
    Statistics statistics;

    Scene(const SurfaceModel& model, const Tracer& tracer, const Job& job);
};

} // namespace keiko
