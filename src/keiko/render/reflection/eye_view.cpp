#include "keiko/render/reflection/eye_view.h"

#include <utility>

namespace keiko {

EyeView without_border(EyeView view, int width) {
    const auto w = static_cast<std::size_t>(width);
    const std::size_t height = view.samples.size() / w;
    auto sample = view.samples.begin();
    for (std::size_t y = 1; y + 1 < height; ++y)
        for (std::size_t x = 1; x + 1 < w; ++x) *sample++ = view.samples[y * w + x];
    view.samples.erase(sample, view.samples.end());
    auto inner = view.spots.begin();
    for (LitSpot& spot : view.spots) {
        const std::size_t x = spot.sample % w, y = spot.sample / w;
        if (x == 0 || y == 0 || x + 1 == w || y + 1 == height) continue;
        spot.sample = (y - 1) * (w - 2) + x - 1;
        *inner++ = spot;
    }
    view.spots.erase(inner, view.spots.end());
    return view;
}

} // namespace keiko
