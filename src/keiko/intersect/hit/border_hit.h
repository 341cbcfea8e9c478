#pragma once

#include "keiko/intersect/hit/crossing.h"
#include "keiko/intersect/subpatch/traced_model.h"

namespace keiko {

/// A hit and what tells whether a neighbouring leaf or face may have found it too.
struct BorderHit {
    Hit hit;
    std::uint32_t leaf = no_index; ///< index among the placed leaves
    Vec2 uv{0};                    ///< of that leaf
    double sine = 0;     ///< of the angle to the surface; above 0 where the ray leaves the face
    bool at_end = false; ///< of its leaf or its patch, where the next one may have found it
    bool beyond = false; ///< its place is off its leaf, if by no more than the error
    bool own = true;     ///< beyond doubt on that share of the face that no other leaf answers for
};

BorderHit border_hit(const TracedModel& model, const Crossing& crossing, Hit hit,
                     const Vec3& direction);

} // namespace keiko
