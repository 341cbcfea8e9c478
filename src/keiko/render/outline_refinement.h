#pragma once

#include "keiko/render/eye_probes.h"
#include "keiko/render/outline_cell.h"

namespace keiko {

/// A part of a pixel that shows one smooth thing, and what is seen there.
struct PixelPart {
    std::size_t pixel = 0;
    double share = 0; ///< of the pixel
    EyeSample sample{};
};

/// Pixels that hold outlines, in parts.
struct RefinedPixels {
    std::vector<PixelPart> parts; ///< by rising pixel; the shares of each are 1 together
    std::vector<LitSpot> spots;   ///< of the parts, whose numbers are their samples
    std::vector<EyeView> views;   ///< what the samples point into
    PathCounts paths;
};

/// Divides `pixels`, adaptively: cells whose corners and centre see one smooth thing stay whole,
/// those that one straight outline crosses are split along it, where it is found by halving, and
/// others become quarters, `finest` times at the most, as do those whose image on the lamps' plane
/// is bent. Pixels that turn out to be whole and have a `centre` are left out of the result.
RefinedPixels refined_pixels(const Integrator& integrator, const PreparedCamera& camera,
                             std::vector<OutlineCell> pixels, int finest);

} // namespace keiko
