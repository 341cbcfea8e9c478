#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/basics/face_limits.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/inspect/seams/model_borders.h"

#include <array>
#include <vector>

namespace keiko {

/// A face that lies on another one, all over.
struct IdenticalFaces {
    std::array<PlacedFace, 2> faces{}; ///< the face, and the one that it lies on
    bool mutual = false; ///< the second lies on the first too: they are one surface twice
    bool deep = false;   ///< inside the borders of the second, by more than the limit
    double distance = 0; ///< mm, the largest from places of the first to the second
    double limit = 0;    ///< mm: StructureLimits::identical_face of the first
    Vec3 place{0};       ///< world, mm: where it is farthest off
};

/// The faces in the scope that lie on others to within their limits, by the first of them. Two
/// faces that lie on each other are listed once. Nine places of each border curve are tested, and a
/// grid of 5 x 5 places of the material of each patch. No such face is missed; one may be listed
/// that differs between these places.
std::vector<IdenticalFaces> identical_faces(const ModelBorders& borders, const FaceLimits& limits,
                                            const Job& job = {});

} // namespace keiko
