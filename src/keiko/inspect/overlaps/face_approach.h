#pragma once

#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/overlaps/edge_samples.h"

#include <vector>

namespace keiko {

/// The place of a face that is nearest to a sample of an edge of another face.
struct FaceApproach {
    std::uint32_t sample = 0; ///< of FreeEdgeSamples
    double offset = 0;        ///< mm, of the sample, positive on the side of `normal`
    Vec3 foot{0};             ///< world, mm
    Vec3 normal{0};           ///< of the face at the foot, unit, along du x dv
    bool along = false; ///< the edge runs with the face there: within `parallel_borders` of it
};

/// Samples of the edges of other faces, ascending, that come within `join` mm of a placed face,
/// farther than that from its borders. The natural sides of a face without loops are borders too.
std::vector<FaceApproach> approaches_to(const SurfaceModel& model, const PlacedFace& face,
                                        const FreeEdgeSamples& samples, double join);

} // namespace keiko
