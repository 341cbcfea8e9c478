#include "keiko/render/eye_view.h"

namespace keiko {

EyeView without_border(const EyeView& view, int width) {
    const auto w = static_cast<std::size_t>(width);
    const std::size_t height = view.samples.size() / w;
    EyeView inner;
    inner.samples.reserve((w - 2) * (height - 2));
    for (std::size_t y = 1; y + 1 < height; ++y)
        for (std::size_t x = 1; x + 1 < w; ++x) inner.samples.push_back(view.samples[y * w + x]);
    for (LitSpot spot : view.spots) {
        const std::size_t x = spot.sample % w, y = spot.sample / w;
        if (x == 0 || y == 0 || x + 1 == w || y + 1 == height) continue;
        spot.sample = (y - 1) * (w - 2) + x - 1;
        inner.spots.push_back(spot);
    }
    return inner;
}

} // namespace keiko
