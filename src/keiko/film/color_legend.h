#pragma once

#include "keiko/film/film.h"

#include <functional>
#include <string>
#include <vector>

namespace keiko {

/// A number beside a legend's bar.
struct LegendTick {
    double position = 0; ///< 0 at the bottom of the bar to 1 at its top
    std::string text{};  ///< short: some 8 characters have room
};

/// A bar of colours with numbers at its right and the unit above.
struct ColorLegend {
    std::string unit{};                 ///< "1/mm"
    std::function<Rgb(double)> color{}; ///< display colour, from 0 at the bottom to 1 at the top
    std::vector<LegendTick>
        ticks{}; ///< by importance: one that would lie on an earlier is left out
};

/// A number as legends write it, with up to 6 digits: "1e-05", "-2.5".
std::string legend_number(double value);

/// Ticks of a bar from one number to another: its ends, its middle and its quarters, each as `text`
/// writes its number.
std::vector<LegendTick> even_ticks(double low, double high,
                                   const std::function<std::string(double)>& text = legend_number);

/// The picture (3 channels) with a legend added at its right; it is at least so high that the
/// legend can be read.
Image with_color_legend(const Image& picture, const ColorLegend& legend);

} // namespace keiko
