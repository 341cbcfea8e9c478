#include "keiko/film/false_color.h"

#include "keiko/base/error.h"
#include "keiko/film/contour_lines.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

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

namespace {

/// Sizes of a legend, in pixels at letters of the smallest scale.
constexpr int legend_width = 96, margin = 16, bar_width = 20;
constexpr int least_height = 64; ///< for the legend to be readable

/// Letters that can be read where the picture is shown whole.
int letter_scale(const Image& picture) {
    constexpr int height_of_letters = 420;
    return std::clamp(picture.height / height_of_letters, 1, 8);
}

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
void paint_bar(Image& picture, int left, int right, int top, int bottom) {
    for (int y = top; y < bottom; ++y) {
        const Rgb color = jet(1 - (y + 0.5 - top) / (bottom - top));
        for (int x = left; x < right; ++x) {
            float* pixel = picture.pixel(x, y);
            pixel[0] = static_cast<float>(color.r);
            pixel[1] = static_cast<float>(color.g);
            pixel[2] = static_cast<float>(color.b);
        }
    }
}

Image with_legend(const Image& picture, const FalseColorScale& scale, ShownQuantity quantity) {
    const int size = letter_scale(picture);
    Image wide = widened(picture, picture.width + legend_width * size,
                         std::max(picture.height, least_height));
    const int left = picture.width + margin * size, right = left + bar_width * size;
    const int top = 2 * margin * size, bottom = wide.height - margin * size;
    paint_bar(wide, left, right, top, bottom);
    Overlay overlay;
    overlay.texts.push_back({.at = Vec2(left, margin * size / 2.0),
                             .text = std::string(unit_of(quantity)),
                             .scale = size});
    for (const double value : round_values(scale)) {
        const double y = bottom - (bottom - top) * scale_position(scale, value);
        overlay.lines.push_back({.points = {Vec2(right, y), Vec2(right + 4 * size, y)},
                                 .color = Rgb(1),
                                 .width = static_cast<double>(size)});
        overlay.texts.push_back({.at = Vec2(right + 7 * size, y - text_size("0", size).y / 2),
                                 .text = name_of(value),
                                 .scale = size});
    }
    return with_overlay(std::move(wide), overlay);
}

/// Values of the quantity that is shown, 1 channel; not a number where a picture of illuminance
/// shows no surface.
Image values_of(const Film& film, ShownQuantity quantity) {
    if (quantity == ShownQuantity::luminance) return luminance_of(film);
    const auto layer = film.aovs.find(Aov::illuminance);
    if (layer == film.aovs.end()) throw Error("", "", "the picture has no layer of illuminance");
    Image lux = layer->second;
    for (std::size_t i = 0; i < lux.values.size(); ++i)
        if (!(film.alpha.values[i] > 0)) lux.values[i] = std::numeric_limits<float>::quiet_NaN();
    return lux;
}

/// Display value of what has none.
constexpr float no_value = 0.25F;

Image colored(const Image& values, const FalseColorScale& scale) {
    Image picture = false_color(values, scale);
    for (std::size_t i = 0; i < values.values.size(); ++i)
        if (std::isnan(values.values[i])) std::fill_n(&picture.values[3 * i], 3, no_value);
    return picture;
}

Overlay iso_lines_of(const Image& values, const FalseColorScale& scale) {
    std::vector<Contour> contours;
    for (const double value : round_values(scale)) {
        contours.push_back({name_of(value), iso_lines(values, value)});
        for (Polyline& line : contours.back().lines) line.color = Rgb(0), line.width = 1;
    }
    return labelled_contours(contours, values.width, values.height, letter_scale(values));
}

} // namespace

std::vector<double> round_values(const FalseColorScale& scale) {
    const double low = std::log10(scale.minimum), high = std::log10(scale.maximum);
    constexpr double roomy = 3, close = 1.7; // decades
    const auto steps = high - low <= close   ? std::vector<double>{1, 1.5, 2, 3, 5, 7.5}
                       : high - low <= roomy ? std::vector<double>{1, 2, 5}
                                             : std::vector<double>{1};
    std::vector<double> values;
    for (int power = static_cast<int>(std::floor(low)); power <= high + slack; ++power)
        for (const double step : steps) {
            const double value = std::stod(name_of(step) + "e" + std::to_string(power));
            const double at = std::log10(value);
            if (at >= low - slack && at <= high + slack) values.push_back(value);
        }
    return values;
}

std::string_view unit_of(ShownQuantity quantity) {
    return quantity == ShownQuantity::luminance ? "cd/m2" : "lx";
}

Image false_color_picture(const Film& film, const FalseColorScale& scale, bool lines,
                          ShownQuantity quantity) {
    const Image values = values_of(film, quantity);
    Image picture = colored(values, scale);
    if (lines) picture = with_overlay(std::move(picture), iso_lines_of(values, scale));
    return with_legend(picture, scale, quantity);
}

} // namespace keiko
