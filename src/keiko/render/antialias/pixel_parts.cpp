#include "keiko/render/antialias/pixel_parts.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace keiko {

void PixelParts::open(EyeView view) {
    for (const EyeSample& seen : view.samples) result_.paths += seen.paths;
    kept_.assign(view.samples.size(), {});
    result_.views.push_back(std::move(view));
}

void PixelParts::keep(std::size_t sample, std::size_t pixel, double share) {
    kept_[sample] = result_.parts.size();
    result_.parts.push_back({pixel, share, seen(sample)});
}

void PixelParts::close() {
    for (LitSpot spot : result_.views.back().spots)
        if (const auto part = kept_[spot.sample]) {
            spot.sample = *part;
            result_.spots.push_back(spot);
        }
}

RefinedPixels PixelParts::finish(const PathCounts& probes) {
    std::vector<std::size_t> order(result_.parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return result_.parts[a].pixel < result_.parts[b].pixel;
    });
    std::vector<PixelPart> parts;
    parts.reserve(order.size());
    std::vector<std::size_t> place(order.size());
    for (const std::size_t i : order) {
        place[i] = parts.size();
        parts.push_back(result_.parts[i]);
    }
    result_.parts = std::move(parts);
    for (LitSpot& spot : result_.spots) spot.sample = place[spot.sample];
    result_.paths += probes;
    return std::move(result_);
}

} // namespace keiko
