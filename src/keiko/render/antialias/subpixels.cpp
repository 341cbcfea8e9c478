#include "keiko/render/antialias/subpixels.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace keiko {

void Subpixels::open(SampleBatch view) {
    for (const PixelSample& seen : view.samples) result_.paths += seen.paths;
    kept_.assign(view.samples.size(), {});
    result_.views.push_back(std::move(view));
}

void Subpixels::keep(std::size_t sample, std::size_t pixel, double share) {
    kept_[sample] = result_.parts.size();
    result_.parts.push_back({pixel, share, seen(sample)});
}

void Subpixels::close() {
    for (ShadingPoint point : result_.views.back().points)
        if (const auto part = kept_[point.sample]) {
            point.sample = *part;
            result_.points.push_back(point);
        }
}

RefinedPixels Subpixels::finish(const HitStatistics& probes) {
    std::vector<std::size_t> order(result_.parts.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return result_.parts[a].pixel < result_.parts[b].pixel;
    });
    std::vector<Subpixel> parts;
    parts.reserve(order.size());
    std::vector<std::size_t> place(order.size());
    for (const std::size_t i : order) {
        place[i] = parts.size();
        parts.push_back(result_.parts[i]);
    }
    result_.parts = std::move(parts);
    for (ShadingPoint& point : result_.points) point.sample = place[point.sample];
    result_.paths += probes;
    return std::move(result_);
}

} // namespace keiko
