#pragma once

#include "keiko/render/reflection/eye_view.h"

#include <optional>
#include <vector>

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

/// Collects parts of pixels out of views that hold more than those.
class PixelParts {
public:
    /// Begins with a view, of which parts are taken next.
    void open(EyeView view);
    const EyeSample& seen(std::size_t sample) const { return result_.views.back().samples[sample]; }
    /// Takes a sample of the view for a part of a pixel.
    void keep(std::size_t sample, std::size_t pixel, double share);
    /// Ends with the view: the spots of the samples that were taken go with them.
    void close();
    /// All of them; `probes`: what was looked at besides.
    RefinedPixels finish(const PathCounts& probes);

private:
    RefinedPixels result_;
    std::vector<std::optional<std::size_t>> kept_; ///< parts of the samples of the view
};

} // namespace keiko
