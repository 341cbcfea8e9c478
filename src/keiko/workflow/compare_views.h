#pragma once

#include "keiko/compare/alignment/closest_point_query.h"
#include "keiko/compare/outlines/outline_difference.h"
#include "keiko/compare/shape/deviation.h"
#include "keiko/compare/shape/deviation_map.h"
#include "keiko/workflow/compare_options.h"
#include "keiko/workflow/zoned_limits.h"

namespace keiko {

/// Limits of the faces of both bodies.
struct LimitPair {
    FaceLimits before, after;
};

/// Both bodies ready to be rendered, and their deviation.
struct ComparedScenes {
    const Scene& before;
    const Scene& after;
    const ClosestPointQuery &feet_before, &feet_after;
    SharedFaces& faces;
    const Deviation& deviation; ///< of the latter from the former
    const LimitPair& limits;
};

/// Renders both under the same cameras and lamps, compares pictures and reflection lines, and draws
/// the distance maps. Adds rig, views and pictures to the result. Throws Error, Cancelled.
void compare_views(const ComparedScenes& scenes, const CompareBodiesOptions& options,
                   CompareResult& result, const Job& job);

} // namespace keiko
