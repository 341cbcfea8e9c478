#pragma once

#include "keiko/render/lighting/pixel_rectangle.h"
#include "keiko/render/reflection/shading_point.h"

#include <vector>

namespace keiko {

/// A shading point of a pixel that holds an outline.
struct OutlineSpot {
    Pixel pixel;
    const ShadingPoint* point;
};

/// Shading points of one smooth surface in a row along an outline.
struct EdgeRun {
    std::vector<const ShadingPoint*> points;
    std::vector<double> along; ///< where each lies from the first to the last, rising
};

/// Groups of shading points of one smooth surface each: two are in one if shading points that
/// continue() each other lead from one to the other.
std::vector<std::vector<OutlineSpot>> smooth_surfaces(std::vector<OutlineSpot> points);

/// All of `shading points`, which are of one depth, in rows along straight pieces of outlines: each
/// row of one smooth surface, its pixels apart, at most two off a line and three from one to the
/// next, and sixteen from end to end.
std::vector<EdgeRun> edge_runs(const std::vector<OutlineSpot>& points);

} // namespace keiko
