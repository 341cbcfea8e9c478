#include "keiko/render/outlines.h"

#include <algorithm>

namespace keiko {

Outlines::Outlines(int width, int height)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height)) {}

const Outlines::Pixel& Outlines::at(int x, int y) const {
    return pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                   static_cast<std::size_t>(x)];
}

void Outlines::set(int x, int y, const EyeSample& sample) {
    if (!sample.hit) return;
    const Hit& hit = *sample.hit;
    pixels_[static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
            static_cast<std::size_t>(x)] = {true,
                                            sample.mirrored_face.has_value(),
                                            sample.torn,
                                            {hit.position, hit.normal, sample.paint}};
}

bool Outlines::differ(const Pixel& a, const Pixel& b) {
    if (a.hit != b.hit) return true;
    return a.hit && (a.mirrors_body != b.mirrors_body || !continues(a.place, b.place));
}

bool Outlines::cross(int x, int y) const {
    const Pixel& here = at(x, y);
    if (here.torn) return true;
    for (int j = std::max(y - 1, 0); j <= std::min(y + 1, height_ - 1); ++j)
        for (int i = std::max(x - 1, 0); i <= std::min(x + 1, width_ - 1); ++i)
            if (differ(here, at(i, j))) return true;
    return false;
}

} // namespace keiko
