#include "keiko/workflow/patch_picture.h"

#include "keiko/workflow/patch_colors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr int intervals = 4;                            ///< of a patch between isoparametric lines
constexpr double thin = 0.9, knot_line = 1.5, edge = 2; ///< widths, pixels

Rgb mixed(const Rgb& below, const Rgb& above, double share) {
    return below * (1 - share) + above * share;
}

/// Share of a pixel that a line of this width covers, its middle `distance` pixels away.
double line_cover(double width, double distance) {
    return std::clamp((width + 1) / 2 - distance, 0.0, std::min(width, 1.0));
}

/// Distance in pixels from a pixel's centre to the border of what a layer of indices shows there;
/// infinite farther than two pixels away. The share of a window of 5 x 5 pixels, weighted by
/// binomials of variance 1, that lies beyond a straight border is nearly the normal distribution at
/// the distance, and this the logistic one.
double border_distance(const FilmSight& sight, Aov layer, int x, int y) {
    constexpr std::array<double, 5> weights{1, 4, 6, 4, 1};
    constexpr double logistic = 1.702; // the best fit of the normal distribution by a logistic one
    const float own = *sight.layer(layer, x, y);
    double same = 0, other = 0;
    for (int j = 0; j < 5; ++j)
        for (int i = 0; i < 5; ++i) {
            const int column = std::clamp(x + i - 2, 0, sight.width() - 1);
            const int row = std::clamp(y + j - 2, 0, sight.height() - 1);
            const double weight =
                weights[static_cast<std::size_t>(i)] * weights[static_cast<std::size_t>(j)];
            (*sight.layer(layer, column, row) == own ? same : other) += weight;
        }
    if (other == 0) return std::numeric_limits<double>::infinity();
    return std::max(0.0, std::log(same / other) / logistic);
}

/// One parameter of the patches as isoparametric lines.
class Parameter {
public:
    /// `channel` 0 is u, 1 is v.
    Parameter(const FilmSight& sight, int channel)
        : values_(
              sight,
              [&](int x, int y) {
                  return sight.at(x, y) ? double{sight.layer(Aov::uv, x, y)[channel]}
                                        : std::numeric_limits<double>::quiet_NaN();
              },
              Aov::patch) {}

    /// Cover of the lines inside a patch. It fades between 6 and 3 pixels from line to line.
    double inner(int x, int y) const {
        const double gradient = values_.gradient(x, y), value = values_.at(x, y);
        if (!(gradient > 0)) return 0;
        const double line = std::clamp(std::round(value * intervals), 1.0, intervals - 1.0);
        const double apart = 1 / (intervals * gradient);
        return line_cover(thin, std::abs(value - line / intervals) / gradient) *
               std::clamp((apart - 3) / 3, 0.0, 1.0);
    }

    /// Cover of the borders of patches.
    double border(int x, int y) const {
        const double gradient = values_.gradient(x, y), value = values_.at(x, y);
        if (!(gradient > 0)) return 0;
        return line_cover(knot_line, std::min(value, 1 - value) / gradient) *
               std::clamp((1 / gradient - 3) / 3, 0.0, 1.0);
    }

private:
    PixelValues values_;
};

} // namespace

Image isoparm_picture(const FilmSight& sight) {
    const Rgb plain(0.86), red(0.8, 0.2, 0.12), blue(0.1, 0.3, 0.75), knots(0.16, 0.18, 0.24);
    const Parameter u(sight, 0), v(sight, 1);
    Image picture = shaded_picture(sight, [&](int x, int y, const Seen&) {
        if (!sight.is_body(x, y)) return Rgb(0.5);
        Rgb color = mixed(mixed(plain, red, u.inner(x, y)), blue, v.inner(x, y));
        color = mixed(color, knots, std::max(u.border(x, y), v.border(x, y)));
        return mixed(color, Rgb(0), line_cover(edge, border_distance(sight, Aov::face, x, y)));
    });
    return with_caption(std::move(picture),
                        "isoparms: u red, v blue, 4 to a patch; patch borders dark, faces black");
}

Image patch_picture(const FilmSight& sight) {
    const std::map<int, Rgb> colors = patch_colors(sight);
    const Rgb dark(0.12);
    Image picture = shaded_picture(sight, [&](int x, int y, const Seen&) {
        if (!sight.is_body(x, y)) return Rgb(0.5);
        const Rgb own = colors.at(static_cast<int>(*sight.layer(Aov::patch, x, y)));
        const double patch = line_cover(thin, border_distance(sight, Aov::patch, x, y));
        const double face = line_cover(edge, border_distance(sight, Aov::face, x, y));
        return mixed(own, dark, std::max(patch, face));
    });
    return with_caption(std::move(picture),
                        "patches: one colour each, " + std::to_string(colors.size()) + " seen");
}

} // namespace keiko
