#pragma once

#include "keiko/trace/leaf_kernels.h"
#include "keiko/trace/traced_ray.h"

namespace keiko {

/// A ray as two planes in a leaf's frame, for any angle between them: one holds the frame's
/// normal, the other lies as flat over the leaf as the ray.
struct FrameRay {
    PlanePair planes;
    Vec3 foot{0};      ///< in the frame, the place of the ray nearest to the frame's centre
    Vec3 direction{0}; ///< in the frame, for one mm
    double foot_s = 0; ///< mm along the ray from its start
    double blur = 0;   ///< mm, bound of the distance of ray and surface to the exact ones

    /// Distance along the ray of a place of the frame near it.
    double s_at(const Vec3& place) const {
        return foot_s + (place - foot).dot(direction) / direction.dot(direction);
    }
};

FrameRay frame_ray(const TracedRay& ray, const HotLeaf& leaf);

/// The part of the leaf's [-1, 1]^2 that the ray can meet, by the two strips around the place where
/// it meets the frame's plane; empty when it meets none.
Box2 reachable(const FrameRay& ray, const HotLeaf& leaf);

} // namespace keiko
