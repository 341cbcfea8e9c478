#include "keiko/film/signed_color_picture.h"

#include "keiko/film/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace keiko {
namespace {

constexpr int legend_width = 160, margin = 16, bar_width = 24; ///< pixels
constexpr int least_height = 128;                              ///< for the legend to be readable
const Rgb backdrop(0.07), far_color(1, 0, 1);

void put(float* pixel, const Rgb& color) {
    pixel[0] = static_cast<float>(color.r);
    pixel[1] = static_cast<float>(color.g);
    pixel[2] = static_cast<float>(color.b);
}

Rgb color_of(float value, float facing, double most) {
    if (std::isnan(value)) return backdrop;
    const double shade = 0.55 + 0.45 * double{facing};
    return (std::isinf(value) ? far_color : signed_color(double{value} / most)) * shade;
}

std::string number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), value == 0 ? "0" : "%+g", value);
    return text.data();
}

void draw_legend(Image& picture, int left, double most, const std::string& unit) {
    constexpr int letters = 2;
    const int top = 3 * margin, bottom = picture.height - margin;
    for (int y = top; y < bottom; ++y)
        for (int x = left; x < left + bar_width; ++x)
            put(picture.pixel(x, y), signed_color(1 - 2 * (y + 0.5 - top) / (bottom - top)));
    Overlay overlay;
    overlay.texts.push_back({.at = Vec2(left, margin / 2.0), .text = unit, .scale = letters});
    for (const double share : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
        const double y = (top + bottom) / 2.0 - share * (bottom - top) / 2.0;
        const double right = left + bar_width;
        overlay.lines.push_back(
            {.points = {Vec2(right, y), Vec2(right + 4, y)}, .color = Rgb(1), .width = 1});
        overlay.texts.push_back({.at = Vec2(right + 7, y - text_size("0", letters).y / 2),
                                 .text = number(share * most),
                                 .scale = letters});
    }
    picture = with_overlay(std::move(picture), overlay);
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

Image signed_color_picture(const Image& values, const Image& facing, double most,
                           const std::string& unit) {
    Image picture(values.width + legend_width, std::max(values.height, least_height), 3);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x) {
            const bool inside = x < values.width && y < values.height;
            put(picture.pixel(x, y),
                inside ? color_of(*values.pixel(x, y), *facing.pixel(x, y), most) : Rgb(0));
        }
    draw_legend(picture, values.width + margin, most, unit);
    return picture;
}

double round_scale(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    for (const double step : {1.0, 2.0, 5.0})
        if (value <= step * power * (1 + 1e-9)) return step * power;
    return 10 * power;
}

} // namespace keiko
