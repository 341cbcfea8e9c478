#pragma once

#include "keiko/render/reflection/sample_batch.h"

#include <optional>
#include <vector>

namespace keiko {

/// A part of a pixel that shows one smooth thing, and what is seen there.
struct Subpixel {
    std::size_t pixel = 0;
    double share = 0; ///< of the pixel
    PixelSample sample{};
};

/// Pixels that hold outlines, in parts.
struct RefinedPixels {
    std::vector<Subpixel> parts;      ///< by rising pixel; the shares of each are 1 together
    std::vector<ShadingPoint> points; ///< of the parts, whose numbers are their samples
    std::vector<SampleBatch> views;   ///< what the samples point into
    HitStatistics paths;
};

/// Collects parts of pixels out of views that hold more than those.
class Subpixels {
public:
    /// Begins with a view, of which parts are taken next.
    void open(SampleBatch view);
    const PixelSample& seen(std::size_t sample) const {
        return result_.views.back().samples[sample];
    }
    /// Takes a sample of the view for a part of a pixel.
    void keep(std::size_t sample, std::size_t pixel, double share);
    /// Ends with the view: the shading points of the samples that were taken go with them.
    void close();
    /// All of them; `probes`: what was looked at besides.
    RefinedPixels finish(const HitStatistics& probes);

private:
    RefinedPixels result_;
    std::vector<std::optional<std::size_t>> kept_; ///< parts of the samples of the view
};

} // namespace keiko
