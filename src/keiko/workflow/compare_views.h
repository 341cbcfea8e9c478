#pragma once

#include "keiko/compare/shape/deviation_map.h"
#include "keiko/workflow/compare_bodies.h"

namespace keiko {

/// Both bodies ready to be rendered, and their deviation.
struct ComparedScenes {
    const Scene& before;
    const Scene& after;
    const ClosestPointQuery &feet_before, &feet_after;
    SharedFaces& faces;
    const Deviation& deviation; ///< of the latter from the former
};

/// Renders both under the same cameras and lamps, compares pictures and reflection lines, and draws
/// the distance maps. Adds rig, views and pictures to the result. Throws Error, Cancelled.
void compare_views(const ComparedScenes& scenes, const CompareBodiesOptions& options,
                   CompareResult& result, const Job& job);

} // namespace keiko
