#include "keiko/render/outlines.h"

namespace keiko {
namespace {

/// Whether two pixels do not show the same smooth thing.
bool differ(const EyeSample& a, const EyeSample& b) {
    if (!a.hit || !b.hit) return a.hit != b.hit;
    return a.mirrored_face.has_value() != b.mirrored_face.has_value() ||
           !continues(place_of(a), place_of(b));
}

} // namespace

std::vector<bool> outlined_pixels(std::span<const EyeSample> samples, int width) {
    const auto w = static_cast<std::size_t>(width);
    const auto crossed = [&](std::size_t i) {
        if (samples[i].torn) return true;
        for (const std::size_t row : {i - w, i, i + w})
            for (const std::size_t other : {row - 1, row, row + 1})
                if (differ(samples[i], samples[other])) return true;
        return false;
    };
    std::vector<bool> outlined;
    for (std::size_t row = w; row + w < samples.size(); row += w)
        for (std::size_t x = 1; x + 1 < w; ++x) outlined.push_back(crossed(row + x));
    return outlined;
}

} // namespace keiko
