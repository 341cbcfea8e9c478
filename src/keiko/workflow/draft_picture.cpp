#include "keiko/workflow/draft_picture.h"

#include "keiko/film/color_legend.h"
#include "keiko/film/signed_color_picture.h"
#include "keiko/inspect/regularity/face_draft.h"
#include "keiko/workflow/analysis_scale.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Degrees: normals of films are floats, and walls along the pull are no undercuts by rounding.
constexpr double float_angle = 1e-4;

Rgb mixed(const Rgb& a, const Rgb& b, double share) {
    const double t = std::clamp(share, 0.0, 1.0);
    return a * (1 - t) + b * t;
}

/// Colours of draft angles, which differ in each usual colour blindness.
struct DraftColors {
    double minimum;   ///< degrees
    ValueRange range; ///< degrees

    Rgb at(double angle) const {
        if (angle < -float_angle)
            return mixed({0.98, 0.45, 0.32}, {0.68, 0.02, 0.05},
                         angle / std::min(range.low, -1e-9));
        if (angle < minimum - float_angle) return {0.99, 0.84, 0.2};
        return mixed({0.6, 0.8, 0.95}, {0.08, 0.27, 0.75},
                     (angle - minimum) / std::max(range.high - minimum, 1e-9));
    }
    /// Mean from `angle - reach` to `angle + reach`.
    Rgb mean(double angle, double reach) const {
        constexpr int steps = 8;
        Rgb sum;
        for (int i = 0; i < steps; ++i) sum += at(angle + reach * ((2 * i + 1.0) / steps - 1));
        return sum * (1.0 / steps);
    }
};

ValueRange range_of(const AnalysisOptions& options, const FilmSight& sight,
                    const PixelValues& angles) {
    constexpr double straight = 90, wide = 5, without_minimum = 15;
    if (options.scale.range) return *options.scale.range;
    double most = options.draft > 0 ? wide * options.draft : without_minimum;
    if (options.scale.percentile)
        most = round_scale(std::max(
            1.0, quantile_of_sizes(body_values(sight, angles), *options.scale.percentile)));
    most = std::min(most, straight);
    return {-most, most};
}

ColorLegend legend_of(const DraftColors& colors) {
    const auto [low, high] = colors.range;
    ColorLegend legend{
        "degrees",
        [=, low = low, high = high](double share) { return colors.at(low + (high - low) * share); },
        {}};
    for (const double angle : {0.0, colors.minimum, low, high, low / 2, high / 2})
        if (angle >= low && angle <= high)
            legend.ticks.push_back({(angle - low) / (high - low), legend_number(angle)});
    return legend;
}

std::string words_of(const AnalysisOptions& options) {
    const auto thousandths = [](double x) { return legend_number(std::round(x * 1000) / 1000); };
    const Vec3& p = options.pull;
    return "draft against the pull " + thousandths(p.x) + "," + thousandths(p.y) + "," +
           thousandths(p.z) + ": blue from " + legend_number(options.draft) +
           " degrees, yellow below, red undercut";
}

} // namespace

Image draft_picture(const FilmSight& sight, const AnalysisOptions& options) {
    const Vec3 pull = options.pull.normalized();
    const PixelValues angles(sight, [&](int x, int y) {
        const auto seen = sight.at(x, y);
        return seen ? draft_angle(seen->normal, pull) : std::numeric_limits<double>::quiet_NaN();
    });
    const DraftColors colors{options.draft, range_of(options, sight, angles)};
    Image picture = shaded_picture(sight, [&](int x, int y, const Seen&) {
        return sight.is_body(x, y) ? colors.mean(angles.at(x, y), angles.reach(x, y)) : Rgb(0.5);
    });
    return with_color_legend(with_caption(std::move(picture), words_of(options)),
                             legend_of(colors));
}

} // namespace keiko
