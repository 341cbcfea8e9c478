#pragma once

#include "keiko/render/lighting/grid_lights.h"
#include "keiko/render/lighting/light_doubts.h"

#include <optional>
#include <vector>

namespace keiko {

/// A light of which what is seen is linear between the corners of a rectangle.
struct LinearlySeen {
    std::size_t light;
    Rectangle between;
};

/// Lights that are not known yet over a rectangle.
struct OpenLights {
    Lights lit;
    Lights seen; ///< those of them of which it is not known either what is seen
    std::vector<LinearlySeen> linearly_seen{}; ///< the others, and some that are known
};

/// What is seen of a light at a place if it is linear between the corners of a rectangle, where it
/// is known. Nothing where they do not see the same number of parts of it.
std::optional<SeenLight> seen_between_corners(const GridLights& lights, const SpotGrid& grid,
                                              const LinearlySeen& linear, const Pixel& p);

/// Finds what open lights bring to a place.
void find(const OpenLights& open, const SpotGrid& grid, const Pixel& p, GridLights& lights);

} // namespace keiko
