#include "keiko/film/stereo_film.h"

#include <algorithm>

namespace keiko {
namespace {

Image side_by_side(const Image& left, const Image& right) {
    Image both(left.width + right.width, left.height, left.channels);
    for (int y = 0; y < left.height; ++y) {
        const std::ptrdiff_t row = std::ptrdiff_t(left.width) * left.channels;
        std::copy_n(left.pixel(0, y), row, both.pixel(0, y));
        std::copy_n(right.pixel(0, y), row, both.pixel(left.width, y));
    }
    return both;
}

} // namespace

Film side_by_side(const Film& left, const Film& right) {
    Film both{side_by_side(left.color, right.color), side_by_side(left.alpha, right.alpha), {}};
    for (const auto& [aov, layer] : left.aovs)
        both.aovs.emplace(aov, side_by_side(layer, right.aovs.at(aov)));
    return both;
}

Film anaglyph(const Film& left, const Film& right) {
    Film both{right.color, right.alpha, {}};
    for (int y = 0; y < both.color.height; ++y)
        for (int x = 0; x < both.color.width; ++x) {
            const float* seen = left.color.pixel(x, y);
            *both.color.pixel(x, y) = static_cast<float>(luminance({seen[0], seen[1], seen[2]}));
            *both.alpha.pixel(x, y) = std::max(*both.alpha.pixel(x, y), *left.alpha.pixel(x, y));
        }
    return both;
}

} // namespace keiko
