#pragma once

#include "keiko/render/antialias/edge_refinement.h"
#include "keiko/render/lighting/shading_grid.h"
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

/// Adds the light of the shading points of pixels in parts, `width` in a row, to their samples.
/// Each smooth surface in a pixel is lit once, at the place amid what is seen of it, as it is in a
/// pixel of one ray; along straight outlines it is found at some of the pixels and between them,
/// off by no more than `error` of what the eye sees at those that are tested. 0: in each pixel.
void add_shared_light(const Integrator& integrator, int width, double error,
                      RefinedPixels& refined);

} // namespace keiko
