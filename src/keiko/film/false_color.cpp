#include "keiko/film/false_color.h"

#include <algorithm>
#include <cmath>

namespace keiko {

double scale_position(const FalseColorScale& scale, double value) {
    if (!(value > 0)) return 0;
    const double low = std::log10(scale.minimum), high = std::log10(scale.maximum);
    return std::clamp((std::log10(value) - low) / (high - low), 0.0, 1.0);
}

Rgb jet(double position) {
    const double x = 4 * std::clamp(position, 0.0, 1.0);
    return {std::clamp(x - 2, 0.0, 1.0), std::clamp(std::min(x, 4 - x), 0.0, 1.0),
            std::clamp(2 - x, 0.0, 1.0)};
}

Image false_color(const Image& values, const FalseColorScale& scale, int channel) {
    Image display(values.width, values.height, 3);
    for (int y = 0; y < values.height; ++y) {
        for (int x = 0; x < values.width; ++x) {
            const auto value = static_cast<double>(values.pixel(x, y)[channel]);
            const Rgb color = jet(scale_position(scale, value));
            float* out = display.pixel(x, y);
            out[0] = static_cast<float>(color.r);
            out[1] = static_cast<float>(color.g);
            out[2] = static_cast<float>(color.b);
        }
    }
    return display;
}

Image luminance_of(const Film& film) {
    Image y(film.color.width, film.color.height, 1);
    for (std::size_t i = 0; i < y.values.size(); ++i) {
        const float* c = &film.color.values[3 * i];
        y.values[i] = static_cast<float>(luminance(
            {static_cast<double>(c[0]), static_cast<double>(c[1]), static_cast<double>(c[2])}));
    }
    return y;
}

Image false_color(const Film& film, const FalseColorScale& scale) {
    return false_color(luminance_of(film), scale);
}

} // namespace keiko
