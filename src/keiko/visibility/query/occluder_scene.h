#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/intersect/kernels/sub_patch_kernels.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/visibility/boundaries/boundary_piece.h"
#include "keiko/visibility/silhouettes/bounds_tree.h"
#include "keiko/visibility/silhouettes/silhouette_events.h"

#include <vector>

namespace keiko {

/// All that Occluders know of a model.
struct OccluderScene {
    Silhouettes silhouettes;                         ///< of all placed patches
    std::vector<BoundaryPiece> borders;              ///< of all placed faces, then creases
    BoundsTree silhouette_pieces;                    ///< over Silhouettes::pieces
    BoundsTree boundary_pieces;                      ///< over `borders`
    BoundsTree surface;                              ///< over Tracer::boxes(), without normals
    SubPatchKernels kernels = sub_patch_kernels();   ///< of this processor
    CandidateMaker candidates{silhouettes, kernels}; ///< refers to this scene
    SilhouetteSolver solver{silhouettes, kernels};   ///< refers to this scene

    /// Prepares a model; `tracer` is of it, and not kept. Throws Cancelled.
    OccluderScene(const SurfaceModel& model, const Tracer& tracer, const Job& job);
};

} // namespace keiko
