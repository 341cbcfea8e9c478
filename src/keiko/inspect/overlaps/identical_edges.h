#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/basics/face_limits.h"
#include "keiko/inspect/seams/model_borders.h"

#include <array>
#include <vector>

namespace keiko {

/// An edge of the file that lies on another one of the same instance, all along.
struct IdenticalEdges {
    std::array<PlacedFace, 2> faces{}; ///< that the edge bounds, and that the other one bounds
    double length = 0;                 ///< mm of the edge, some
    double distance = 0;               ///< mm, the largest from places of it to the other one
    double limit = 0;                  ///< mm: StructureLimits::identical_edge of the first face
    Vec3 place{0};                     ///< world, mm: where it is farthest off
};

/// Edges that lie on others to within the limits of their faces, each pair once. Two edges that
/// bound one face each, and not the same, are a seam that the file does not join, and no pair.
/// Neither are edges no longer than twice the limit. Places are tested as those of faces are:
/// identical_faces().
std::vector<IdenticalEdges> identical_edges(const ModelBorders& borders, const FaceLimits& limits,
                                            const Job& job = {});

} // namespace keiko
