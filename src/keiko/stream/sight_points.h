#pragma once

#include "keiko/base/export.h"
#include "keiko/light/fog/sight.h"
#include "keiko/stream/trace_rays.h"

namespace KEIKO_API keiko {

/// Reads lines of eyes with lines of sight (see rays_of), and writes what they can see in the fog
/// of the scene's rig. The CSV has a header line, then a row for each eye, in order.
///
/// The first columns are of the surface that the line of sight meets: `distance_m`, its contrast
/// against the horizon from near and from the eye (`near_contrast`, `contrast`), and the distance
/// `visible_to_m` at which it vanishes [Koschmieder1924]. They are empty where it meets nothing,
/// all but the first where the horizon is black, as in fog without ambient light or an open sky.
/// Each sign, `sign.0`, has the `contrast` of its legend at the eye and the distance
/// `legible_to_m`. Each bare lamp, by kind and number, has the `lux` at the eye turned to it and
/// the distance `visible_to_m` [Allard1876]. Signs and lamps have 0 where a body hides them, if the
/// scene was opened with shadows, and signs from behind. Distances are in m, in uniform fog as
/// thick as it is on the way between in the mean.
///
/// Rows are written as eyes come, in constant memory, and are the same bytes for any thread count.
/// Ends early if the sink accepts no more; returns the number of eyes. Throws Error for a scene
/// without fog, without eyes, and for the first malformed line, after the rows of those before it.
std::uint64_t sight_points(const Scene& scene, const SightLimits& limits, const ByteSource& eyes,
                           const ByteSink& rows, const Job& job = {});

} // namespace keiko
