#include "keiko/workflow/distortion_picture.h"

#include "keiko/base/error.h"
#include "keiko/film/color_legend.h"
#include "keiko/film/false_color.h"
#include "keiko/film/signed_color_picture.h"
#include "keiko/workflow/analysis_scale.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace keiko {
namespace {

constexpr double grid_step = 0.02; // slope

PixelValues channel(const FilmSight& sight, const Image& deviations, int number) {
    return {sight, [&](int x, int y) { return double{deviations.pixel(x, y)[number]}; }};
}

ValueRange range_of(const FilmSight& sight, const PixelValues& angles, const AnalysisScale& scale) {
    if (scale.range) return *scale.range;
    std::vector<double> known = body_values(sight, angles);
    if (known.empty())
        throw Error("", "look", "no glass is seen: its faces need a material of glass");
    constexpr double none = 1e-6;
    const double most =
        quantile_of_sizes(std::move(known), scale.percentile.value_or(usual_percentile));
    return {0, round_scale(std::max(none, most))};
}

/// Share of a pixel that the grid's lines across a direction cover, 1.5 pixels wide. They fade
/// where they are closer than four pixels.
double line_share(const PixelValues& slopes, int x, int y) {
    const double value = slopes.at(x, y), change = slopes.gradient(x, y);
    if (!(change > 0)) return 0;
    const double off = std::abs(value - grid_step * std::round(value / grid_step)) / change;
    const double spacing = grid_step / change; // pixels
    return std::clamp(1.25 - off, 0.0, 1.0) * std::clamp(spacing / 2 - 1, 0.0, 1.0);
}

} // namespace

Image distortion_picture(const FilmSight& sight, const Image& deviations,
                         const AnalysisScale& scale) {
    const PixelValues angles = channel(sight, deviations, 0);
    const PixelValues right = channel(sight, deviations, 1), up = channel(sight, deviations, 2);
    const auto [low, high] = range_of(sight, angles, scale);
    const Image picture =
        shaded_picture(sight, [&, low = low, high = high](int x, int y, const Seen&) {
            if (std::isnan(angles.at(x, y))) return Rgb(0.5);
            const double line = std::max(line_share(right, x, y), line_share(up, x, y));
            return jet((angles.at(x, y) - low) / (high - low)) * (1 - 0.8 * line);
        });
    return with_color_legend(picture, {"mrad", jet, even_ticks(low, high)});
}

} // namespace keiko
