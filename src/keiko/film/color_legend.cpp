#include "keiko/film/color_legend.h"

#include "keiko/film/overlay.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace keiko {
namespace {

constexpr int legend_width = 160, margin = 16, bar_width = 24; ///< pixels
constexpr int least_height = 128;                              ///< for the legend to be readable
constexpr int letters = 2;                                     ///< pixels a dot

struct Bar {
    int left, top, bottom; ///< pixels

    int right() const { return left + bar_width; }
    double y(double position) const { return bottom - position * (bottom - top); }
};

void paint(Image& picture, const Bar& bar, const ColorLegend& legend) {
    for (int y = bar.top; y < bar.bottom; ++y) {
        const Rgb color = legend.color(1 - (y + 0.5 - bar.top) / (bar.bottom - bar.top));
        for (int x = bar.left; x < bar.right(); ++x) {
            float* pixel = picture.pixel(x, y);
            pixel[0] = static_cast<float>(color.r);
            pixel[1] = static_cast<float>(color.g);
            pixel[2] = static_cast<float>(color.b);
        }
    }
}

Overlay numbers(const Bar& bar, const ColorLegend& legend) {
    const double height = text_size("0", letters).y;
    Overlay overlay;
    overlay.texts.push_back(
        {.at = Vec2(bar.left, margin / 2.0), .text = legend.unit, .scale = letters});
    std::vector<double> taken;
    for (const LegendTick& tick : legend.ticks) {
        const double y = bar.y(tick.position), right = bar.right();
        if (std::any_of(taken.begin(), taken.end(),
                        [&](double other) { return std::abs(other - y) < height + 2; }))
            continue;
        taken.push_back(y);
        overlay.lines.push_back(
            {.points = {Vec2(right, y), Vec2(right + 4, y)}, .color = Rgb(1), .width = 1});
        overlay.texts.push_back(
            {.at = Vec2(right + 7, y - height / 2), .text = tick.text, .scale = letters});
    }
    return overlay;
}

} // namespace

std::string legend_number(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%g", value == 0 ? 0 : value);
    return text.data();
}

std::vector<LegendTick> even_ticks(double low, double high,
                                   const std::function<std::string(double)>& text) {
    std::vector<LegendTick> ticks;
    for (const double position : {0.0, 1.0, 0.5, 0.25, 0.75})
        ticks.push_back({position, text(low + (high - low) * position)});
    return ticks;
}

Image with_color_legend(const Image& picture, const ColorLegend& legend) {
    Image wide(picture.width + legend_width, std::max(picture.height, least_height), 3);
    for (int y = 0; y < picture.height; ++y)
        std::copy_n(picture.pixel(0, y), picture.width * 3, wide.pixel(0, y));
    const Bar bar{picture.width + margin, 3 * margin, wide.height - margin};
    paint(wide, bar, legend);
    return with_overlay(std::move(wide), numbers(bar, legend));
}

} // namespace keiko
