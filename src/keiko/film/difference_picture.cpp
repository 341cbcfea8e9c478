#include "keiko/film/difference_picture.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

Rgb color_of(float excess) {
    constexpr double darkest = 0.08, lightest = 0.45, deepest_red = 100;
    if (std::isinf(excess)) return {1, 0, 1};
    const double x = excess;
    if (!(x > 1)) return Rgb(darkest + (lightest - darkest) * std::max(x, 0.0));
    const double depth = std::min(std::log(x) / std::log(deepest_red), 1.0);
    return {1, 0.9 * (1 - depth), 0};
}

} // namespace

Image difference_picture(const Image& excess) {
    Image picture(excess.width, excess.height, 3);
    float* out = picture.values.data();
    for (const float value : excess.values) {
        const Rgb color = color_of(value);
        for (const double channel : {color.r, color.g, color.b})
            *out++ = static_cast<float>(channel);
    }
    return picture;
}

} // namespace keiko
