#include "keiko/render/reflection/sample_batch.h"

#include <utility>

namespace keiko {

SampleBatch without_border(SampleBatch view, int width) {
    const auto w = static_cast<std::size_t>(width);
    const std::size_t height = view.samples.size() / w;
    auto sample = view.samples.begin();
    for (std::size_t y = 1; y + 1 < height; ++y)
        for (std::size_t x = 1; x + 1 < w; ++x) *sample++ = view.samples[y * w + x];
    view.samples.erase(sample, view.samples.end());
    auto inner = view.points.begin();
    for (ShadingPoint& point : view.points) {
        const std::size_t x = point.sample % w, y = point.sample / w;
        if (x == 0 || y == 0 || x + 1 == w || y + 1 == height) continue;
        point.sample = (y - 1) * (w - 2) + x - 1;
        *inner++ = point;
    }
    view.points.erase(inner, view.points.end());
    return view;
}

} // namespace keiko
