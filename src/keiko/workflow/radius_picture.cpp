#include "keiko/workflow/radius_picture.h"

#include "keiko/film/color_legend.h"
#include "keiko/film/false_color.h"
#include "keiko/film/signed_color_picture.h"
#include "keiko/workflow/analysis_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// mm: larger radii are flat and have no part in scales.
constexpr double flat_radius = 1e6;
const Rgb unknown_color(0.07), other_color(0.5);

/// Largest absolute principal curvature, 1/mm; NaN without one.
PixelValues largest_curvatures(const FilmSight& sight) {
    return {sight, [&](int x, int y) {
                const float* k = sight.layer(Aov::curvature, x, y);
                return sight.at(x, y) && !std::isnan(k[0])
                           ? std::max(std::abs(double{k[0]}), std::abs(double{k[1]}))
                           : std::numeric_limits<double>::quiet_NaN();
            }};
}

/// Radii that are not flat, mm, of the pixels that show the body.
std::vector<double> radii(const FilmSight& sight, const PixelValues& curvatures) {
    std::vector<double> all;
    for (const double k : body_values(sight, curvatures))
        if (k * flat_radius > 1) all.push_back(1 / k);
    return all;
}

/// A positive number with three digits.
std::string three_digits(double value) {
    const double last = std::pow(10.0, std::floor(std::log10(value)) - 2);
    return legend_number(std::round(value / last) * last);
}

/// The round number (1, 2 or 5 times a power of ten) at or below a positive value.
double round_down(double value) {
    return 1 / round_scale(1 / value);
}

FalseColorScale scale_of(const FilmSight& sight, const PixelValues& curvatures,
                         const AnalysisScale& scale) {
    if (scale.range) return {scale.range->low, scale.range->high};
    const std::vector<double> all = radii(sight, curvatures);
    if (all.empty()) return {1, 1000};
    const double percent = scale.percentile.value_or(usual_percentile);
    const double low = round_down(quantile(all, 100 - percent));
    return {low, std::max(round_scale(quantile(all, percent)), 10 * low)};
}

ColorLegend legend_of(const FalseColorScale& scale) {
    ColorLegend legend{"mm", [](double position) { return jet(1 - position); }, {}};
    for (const double radius : {scale.minimum, scale.maximum})
        legend.ticks.push_back({scale_position(scale, radius), legend_number(radius)});
    for (const double radius : round_values(scale))
        legend.ticks.push_back({scale_position(scale, radius), legend_number(radius)});
    return legend;
}

std::string mask_words(const FilmSight& sight, const PixelValues& curvatures, double radius) {
    const std::vector<double> all = radii(sight, curvatures);
    const std::string least =
        all.empty() ? "none" : three_digits(*std::min_element(all.begin(), all.end())) + " mm";
    return "red: a radius below " + legend_number(radius) + " mm; smallest at a pixel: " + least;
}

} // namespace

Image radius_picture(const FilmSight& sight, const AnalysisScale& scale) {
    const PixelValues curvatures = largest_curvatures(sight);
    const FalseColorScale colors = scale_of(sight, curvatures, scale);
    const Image picture = shaded_picture(sight, [&](int x, int y, const Seen&) {
        if (!sight.is_body(x, y)) return other_color;
        const double k = curvatures.at(x, y);
        if (std::isnan(k)) return unknown_color;
        return jet(k > 0 ? 1 - scale_position(colors, 1 / k) : 0);
    });
    return with_color_legend(picture, legend_of(colors));
}

Image below_radius_picture(const FilmSight& sight, double radius) {
    const Rgb signal(1, 0.12, 0.05), plain(0.62);
    const PixelValues curvatures = largest_curvatures(sight);
    const Image picture = shaded_picture(sight, [&](int x, int y, const Seen&) {
        if (!sight.is_body(x, y)) return other_color;
        const double k = curvatures.at(x, y), reach = curvatures.reach(x, y) + 1e-9 / radius;
        if (std::isnan(k)) return unknown_color;
        const double share = std::clamp((k + reach - 1 / radius) / (2 * reach), 0.0, 1.0);
        return signal * share + plain * (1 - share);
    });
    return with_caption(picture, mask_words(sight, curvatures, radius));
}

} // namespace keiko
