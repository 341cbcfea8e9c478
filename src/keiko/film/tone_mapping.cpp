#include "keiko/film/tone_mapping.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double white_quantile = 0.99;

Rgb color_at(const float* pixel) {
    return {static_cast<double>(pixel[0]), static_cast<double>(pixel[1]),
            static_cast<double>(pixel[2])};
}

std::size_t pixel_count(const Image& image) {
    return static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
}

/// Luminances of the pixels with alpha >= threshold; numbers only.
std::vector<double> luminances(const Film& film, float threshold) {
    std::vector<double> found;
    for (std::size_t i = 0; i < pixel_count(film.color); ++i) {
        if (i < film.alpha.values.size() && !(film.alpha.values[i] >= threshold)) continue;
        const double y = luminance(color_at(&film.color.values[3 * i]));
        if (std::isfinite(y)) found.push_back(y);
    }
    return found;
}

Rgb curved(const Rgb& x, const ToneMapping& mapping) {
    if (mapping.curve == ToneMapping::Curve::linear) return x;
    const double y = luminance(x);
    if (!(y > 0)) return {};
    const bool bent = mapping.curve == ToneMapping::Curve::reinhard;
    return x * ((bent ? reinhard(y, mapping.white) : logarithmic(y)) / y);
}

} // namespace

double srgb_oetf(double linear) {
    if (!(linear > 0)) return 0;
    const double x = std::min(linear, 1.0);
    return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
}

double srgb_eotf(double encoded) {
    if (!(encoded > 0)) return 0;
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double srgb_slope(double linear) {
    const double x = std::min(linear, 1.0);
    return x <= 0.0031308 ? 12.92 : 1.055 / 2.4 * std::pow(x, 1 / 2.4 - 1);
}

double saturation_luminance(double ev) {
    return 1.2 * std::exp2(ev);
}

double reinhard(double x, double white) {
    return x * (1 + x / (white * white)) / (1 + x);
}

double logarithmic(double x) {
    constexpr double lift = 100;
    return std::log1p(lift * x) / std::log1p(lift);
}

double white_luminance(const Film& film) {
    std::vector<double> y = luminances(film, 0.5F);
    if (y.empty()) y = luminances(film, -1);
    if (y.empty()) return 1;
    const double rank = white_quantile * static_cast<double>(y.size() - 1);
    const auto nth = std::next(y.begin(), static_cast<std::ptrdiff_t>(std::lround(rank)));
    std::nth_element(y.begin(), nth, y.end());
    return *nth > 0 ? *nth : 1;
}

Image tone_mapped(const Film& film, const ToneMapping& mapping, bool with_alpha) {
    const double white = mapping.ev ? saturation_luminance(*mapping.ev) : white_luminance(film);
    Image display(film.color.width, film.color.height, with_alpha ? 4 : 3);
    float* out = display.values.data();
    for (std::size_t i = 0; i < pixel_count(film.color); ++i) {
        const Rgb x = curved(color_at(&film.color.values[3 * i]) / white, mapping);
        for (const double channel : {x.r, x.g, x.b})
            *out++ = static_cast<float>(srgb_oetf(channel));
        if (!with_alpha) continue;
        const float alpha = i < film.alpha.values.size() ? film.alpha.values[i] : 1;
        *out++ = std::clamp(alpha, 0.0F, 1.0F);
    }
    return display;
}

} // namespace keiko
