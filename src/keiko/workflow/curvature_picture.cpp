#include "keiko/workflow/curvature_picture.h"

#include "keiko/film/color_legend.h"
#include "keiko/film/false_color.h"
#include "keiko/film/signed_color_picture.h"
#include "keiko/workflow/analysis_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

/// Curvature viewed from the camera, positive in hollows; NaN without a surface.
double curvature_at(AnalysisMode look, const FilmSight& sight, int x, int y) {
    const auto seen = sight.at(x, y);
    if (!seen) return unknown;
    const float* k = sight.layer(Aov::curvature, x, y);
    const double sign = seen->turned ? -1 : 1;
    if (look == AnalysisMode::gauss) return double{k[3]};
    if (look == AnalysisMode::mean) return sign * double{k[2]};
    if (look == AnalysisMode::absolute) return std::abs(double{k[0]}) + std::abs(double{k[1]});
    return sign * double{(look == AnalysisMode::k1) == seen->turned ? k[1] : k[0]};
}

PixelValues curvatures(AnalysisMode look, const FilmSight& sight, const AnalysisOptions& options) {
    if (look == AnalysisMode::section)
        return {sight, [&](int x, int y) { return double{*options.sections->pixel(x, y)}; }};
    return {sight, [&](int x, int y) { return curvature_at(look, sight, x, y); }};
}

ValueRange range_of(AnalysisMode look, const PixelValues& values, const FilmSight& sight,
                    const AnalysisScale& scale) {
    constexpr double flat = 1e-12;
    if (scale.range) return *scale.range;
    const double most =
        round_scale(std::max(flat, quantile_of_sizes(body_values(sight, values),
                                                     scale.percentile.value_or(usual_percentile))));
    return {look == AnalysisMode::absolute ? 0 : -most, most};
}

Image signed_picture(const FilmSight& sight, const PixelValues& values, const ValueRange& range,
                     const std::string& unit) {
    Image shown(sight.width(), sight.height(), 1), facing(sight.width(), sight.height(), 1);
    for (int y = 0; y < sight.height(); ++y)
        for (int x = 0; x < sight.width(); ++x) {
            *shown.pixel(x, y) = static_cast<float>(values.at(x, y));
            if (const auto seen = sight.at(x, y))
                *facing.pixel(x, y) = static_cast<float>(seen->facing());
        }
    return signed_color_picture(shown, facing, range, unit);
}

Image unsigned_picture(const FilmSight& sight, const PixelValues& values, const ValueRange& range) {
    const auto [low, high] = range;
    const Image picture =
        shaded_picture(sight, [&, low = low, high = high](int x, int y, const Seen&) {
            if (!sight.is_body(x, y)) return Rgb(0.5);
            const double value = values.at(x, y);
            return std::isnan(value) ? Rgb(0.07) : jet((value - low) / (high - low));
        });
    return with_color_legend(picture, {"1/mm", jet, even_ticks(low, high)});
}

} // namespace

ValueRange curvature_range(AnalysisMode look, const FilmSight& sight,
                           const AnalysisOptions& options) {
    return range_of(look, curvatures(look, sight, options), sight, options.scale);
}

Image curvature_picture(AnalysisMode look, const FilmSight& sight, const AnalysisOptions& options) {
    const PixelValues values = curvatures(look, sight, options);
    const ValueRange range = range_of(look, values, sight, options.scale);
    if (look == AnalysisMode::absolute) return unsigned_picture(sight, values, range);
    return signed_picture(sight, values, range, look == AnalysisMode::gauss ? "1/mm2" : "1/mm");
}

} // namespace keiko
