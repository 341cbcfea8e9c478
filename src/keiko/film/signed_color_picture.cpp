#include "keiko/film/signed_color_picture.h"

#include "keiko/film/color_legend.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace keiko {
namespace {

const Rgb backdrop(0.07), no_value(0.25), far_color(1, 0, 1);

void put(float* pixel, const Rgb& color) {
    pixel[0] = static_cast<float>(color.r);
    pixel[1] = static_cast<float>(color.g);
    pixel[2] = static_cast<float>(color.b);
}

Rgb color_of(float value, float facing, const ValueRange& range) {
    const double shade = 0.55 + 0.45 * double{facing};
    if (std::isnan(value)) return facing > 0 ? no_value * shade : backdrop;
    return (std::isinf(value) ? far_color : signed_color(signed_share(double{value}, range))) *
           shade;
}

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), value == 0 ? "0" : "%+g", value);
    return text.data();
}

ColorLegend legend_of(const ValueRange& range, const std::string& unit) {
    const auto [low, high] = range;
    return {unit,
            [low = low, high = high](double position) {
                return signed_color(signed_share(low + (high - low) * position, {low, high}));
            },
            even_ticks(low, high, number)};
}

} // namespace

Rgb signed_color(double share) {
    const std::array<Rgb, 5> stops{Rgb(0.02, 0.12, 0.55), Rgb(0.25, 0.55, 0.9), Rgb(0.87),
                                   Rgb(0.95, 0.5, 0.25), Rgb(0.6, 0.02, 0.05)};
    const double at = (std::clamp(share, -1.0, 1.0) + 1) * 2;
    const std::size_t first = std::min<std::size_t>(3, static_cast<std::size_t>(at));
    const double part = at - static_cast<double>(first);
    return stops[first] * (1 - part) + stops[first + 1] * part;
}

double signed_share(double value, const ValueRange& range) {
    const double middle = std::clamp(0.0, range.low, range.high);
    const double reach = value < middle ? middle - range.low : range.high - middle;
    return reach > 0 ? (value - middle) / reach : 0;
}

Image signed_color_picture(const Image& values, const Image& facing, const ValueRange& range,
                           const std::string& unit) {
    Image picture(values.width, values.height, 3);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            put(picture.pixel(x, y), color_of(*values.pixel(x, y), *facing.pixel(x, y), range));
    return with_color_legend(picture, legend_of(range, unit));
}

double round_scale(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (value <= step * power * (1 + 1e-9)) return step * power;
    return 10 * power;
}

} // namespace keiko
