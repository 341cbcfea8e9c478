#pragma once

#include "keiko/compare/alignment/closest_point_query.h"
#include "keiko/film/film.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/scene/camera.h"

namespace keiko {

/// What an eye sees of how far a body lies from another.
struct DeviationMap {
    /// mm, signed as Deviation: 1 channel. Infinity: nothing within reach; no number: no body.
    Image distance;
    Image facing; ///< 1 channel: cosine between view and normal, 0 to 1
};

/// Follows the ray of every pixel's centre to the body and finds the nearest point of the other, up
/// to `reach` mm. The same for any number of threads. Reports stage "deviation map". Throws
/// Cancelled.
DeviationMap deviation_map(const Tracer& body, const Camera& camera, const ClosestPointQuery& other,
                           double reach, const Job& job = {});

} // namespace keiko
