#pragma once

#include "keiko/visibility/boundaries/boundary_piece.h"
#include "keiko/visibility/query/occluders.h"
#include "keiko/visibility/silhouettes/bounds_tree.h"
#include "keiko/visibility/silhouettes/silhouette_events.h"

namespace keiko {

/// All that Occluders know of a model.
struct Occluders::Scene {
    Silhouettes silhouettes;
    std::vector<BoundaryPiece> borders;
    BoundsTree silhouette_pieces, boundary_pieces, surface;
    SubPatchKernels kernels = sub_patch_kernels();
    CandidateMaker candidates{silhouettes, kernels};
    SilhouetteSolver solver{silhouettes, kernels};
    Statistics statistics;

    Scene(const SurfaceModel& model, const Tracer& tracer, const Job& job);
};

} // namespace keiko
