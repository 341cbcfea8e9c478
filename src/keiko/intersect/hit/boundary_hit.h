#pragma once

#include "keiko/intersect/hit/intersection.h"
#include "keiko/intersect/subpatch/traced_model.h"

namespace keiko {

/// A hit and what tells whether a neighbouring sub-patch or face may have found it too.
struct BoundaryHit {
    Hit hit;
    std::uint32_t sub_patch = no_index; ///< index among the placed sub-patches
    Vec2 uv{0};                         ///< of that sub-patch
    double sine = 0;     ///< of the angle to the surface; above 0 where the ray leaves the face
    bool at_end = false; ///< of its sub-patch or its patch, where the next one may have found it
    bool beyond = false; ///< its place is off its sub-patch, if by no more than the error
    bool own = true; ///< beyond doubt on that share of the face that no other sub-patch answers for
};

BoundaryHit boundary_hit(const TracedModel& model, const Crossing& crossing, Hit hit,
                         const Vec3& direction);

} // namespace keiko
