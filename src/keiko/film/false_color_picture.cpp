#include "keiko/film/false_color_picture.h"

#include "keiko/film/iso_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace keiko {
namespace {

constexpr int legend_width = 96, margin = 16, bar_width = 20; ///< pixels
constexpr int least_height = 64;                              ///< for the legend to be readable

/// Names of round numbers from 1e-9 to 1e9.
std::string name_of(double value) {
    std::array<char, 32> text;
    const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
    return {text.data(), end};
}

/// A longer rounding error than that of a power of ten.
constexpr double slack = 1e-9;

Image widened(const Image& picture, int width, int height) {
    Image wide(width, height, picture.channels);
    for (int y = 0; y < picture.height; ++y)
        std::copy_n(picture.pixel(0, y), picture.width * picture.channels, wide.pixel(0, y));
    return wide;
}

/// The bar, its colours as the scale has them.
void paint_bar(Image& picture, int left, int top, int bottom) {
    for (int y = top; y < bottom; ++y) {
        const Rgb color = jet(1 - (y + 0.5 - top) / (bottom - top));
        for (int x = left; x < left + bar_width; ++x) {
            float* pixel = picture.pixel(x, y);
            pixel[0] = static_cast<float>(color.r);
            pixel[1] = static_cast<float>(color.g);
            pixel[2] = static_cast<float>(color.b);
        }
    }
}

Image with_legend(const Image& picture, const FalseColorScale& scale) {
    Image wide =
        widened(picture, picture.width + legend_width, std::max(picture.height, least_height));
    const int left = picture.width + margin, top = 2 * margin, bottom = wide.height - margin;
    paint_bar(wide, left, top, bottom);
    Overlay overlay;
    overlay.texts.push_back({.at = Vec2(left, margin / 2.0), .text = "cd/m2", .scale = 1});
    for (const double value : round_values(scale)) {
        const double y = bottom - (bottom - top) * scale_position(scale, value);
        const double right = left + bar_width;
        overlay.lines.push_back(
            {.points = {Vec2(right, y), Vec2(right + 4, y)}, .color = Rgb(1), .width = 1});
        overlay.texts.push_back({.at = Vec2(right + 7, y - text_size("0", 1).y / 2),
                                 .text = name_of(value),
                                 .scale = 1});
    }
    return with_overlay(std::move(wide), overlay);
}

} // namespace

std::vector<double> round_values(const FalseColorScale& scale) {
    const double low = std::log10(scale.minimum), high = std::log10(scale.maximum);
    constexpr double roomy = 3; // decades
    const auto steps = high - low <= roomy ? std::vector<double>{1, 2, 5} : std::vector<double>{1};
    std::vector<double> values;
    for (int power = static_cast<int>(std::floor(low)); power <= high + slack; ++power)
        for (const double step : steps) {
            const double value = std::stod(name_of(step) + "e" + std::to_string(power));
            const double at = std::log10(value);
            if (at >= low - slack && at <= high + slack) values.push_back(value);
        }
    return values;
}

Image false_color_picture(const Film& film, const FalseColorScale& scale, bool lines) {
    Image picture = false_color(film, scale);
    if (lines) {
        Overlay overlay;
        const Image y = luminance_of(film);
        for (const double value : round_values(scale))
            for (Polyline& line : iso_lines(y, value)) {
                line.color = Rgb(0);
                line.width = 1;
                overlay.lines.push_back(std::move(line));
            }
        picture = with_overlay(std::move(picture), overlay);
    }
    return with_legend(picture, scale);
}

} // namespace keiko
