#pragma once

#include "keiko/render/antialias/edge_refinement.h"
#include "keiko/render/lighting/shading_grid.h"
#include "keiko/render/reflection/shading_point.h"

#include <vector>

namespace keiko {

/// A shading point of a pixel that contains an edge.
struct OutlineSpot {
    Pixel pixel;               ///< of the tile
    const ShadingPoint* point; ///< not null
};

/// Shading points of one smooth surface in a row along an edge.
struct EdgeRun {
    std::vector<const ShadingPoint*> points; ///< one at least
    std::vector<double> along; ///< position of each from the first to the last, rising
};

/// Groups of shading points of one smooth surface each. Two are in one group if a chain of shading
/// points leads from one to the other in which is_same_surface() holds for neighbours.
std::vector<std::vector<OutlineSpot>> smooth_surfaces(std::vector<OutlineSpot> points);

/// Rows of all of `points`, which are of one branch, along straight pieces of edges. Each row is of
/// one smooth surface, its pixels apart: at most two from a line, three from one to the next, and
/// sixteen from end to end.
std::vector<EdgeRun> edge_runs(const std::vector<OutlineSpot>& points);

/// A smooth surface in a pixel in parts, which is lit at one place, as in a pixel of one ray.
struct SharedPlace {
    OutlineSpot lit;                 ///< the one in the middle of the surface's visible part
    std::vector<OutlineSpot> points; ///< all that have its light
};

/// The surfaces of all pixels in parts, `width` pixels in a row, by rising branch. Sorts the
/// shading points, which they point to.
std::vector<SharedPlace> shared_places(int width, RefinedPixels& refined);

/// Adds the light of the shading points of pixels in parts, `width` in a row, to their samples.
/// Each of the shared_places() is lit once. Along straight edges the light is computed at some of
/// the pixels and interpolated between them. The deviation at those that are tested is at most
/// `error` of the visible luminance; 0 computes the light in each pixel.
void add_shared_light(const Integrator& integrator, int width, double error,
                      RefinedPixels& refined);

} // namespace keiko
