#pragma once

#include "keiko/render/lighting/interpolation_errors.h"
#include "keiko/render/lighting/light_samples.h"

#include <optional>
#include <vector>

namespace keiko {

/// A light of which what is seen is linear between the corners of a rectangle.
struct LinearlySeen {
    std::size_t light;
    Rectangle between;
};

/// Lights that are not known yet over a rectangle.
struct UnresolvedLights {
    Lights lit;
    Lights seen; ///< those of them of which it is not known either what is seen
    std::vector<LinearlySeen> linearly_seen{}; ///< the others, and some that are known
};

/// What is seen of a light at a place if it is linear between the corners of a rectangle, where it
/// is known. Nothing where they do not see the same number of parts of it.
std::optional<LightVisibility> seen_between_corners(const LightSamples& lights,
                                                    const ShadingGrid& grid,
                                                    const LinearlySeen& linear, const Pixel& p);

/// Finds what open lights bring to a place.
void find(const UnresolvedLights& open, const ShadingGrid& grid, const Pixel& p,
          LightSamples& lights);

} // namespace keiko
