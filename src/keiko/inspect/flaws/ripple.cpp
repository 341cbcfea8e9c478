#include "keiko/inspect/flaws/face_ripples.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace keiko {
namespace {

/// An extremum of the values.
struct Turn {
    std::size_t index = 0;
    bool cut = false; ///< the line begins or ends there before the values have come back
};

/// Largest and smallest values in alternation, between which the values change by more than
/// `swing`.
std::vector<Turn> turns(std::span<const BendPoint> line, double swing) {
    std::vector<Turn> found;
    std::size_t high = 0, low = 0;
    int direction = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i].bend.xx > line[high].bend.xx) high = i;
        if (line[i].bend.xx < line[low].bend.xx) low = i;
        if (direction >= 0 && line[high].bend.xx - line[i].bend.xx > swing) {
            found.push_back({high, direction == 0});
            direction = -1, low = i;
        } else if (direction <= 0 && line[i].bend.xx - line[low].bend.xx > swing) {
            found.push_back({low, direction == 0});
            direction = 1, high = i;
        }
    }
    if (direction != 0) found.push_back({direction > 0 ? high : low, true});
    return found;
}

double radius_squared(double width) {
    return width * width / (4 * std::numbers::pi * std::numbers::pi);
}

/// The longer one of the steps to and from a point inside the line.
double step_beside(std::span<const BendPoint> line, std::size_t index) {
    return std::max(line[index].length - line[index - 1].length,
                    line[index + 1].length - line[index].length);
}

/// From the line to the way along which the curvature differs most between two places, radians. 0
/// where it differs along all ways, as on a dent, or mostly across the line.
double slant_between(const SecondForm& a, const SecondForm& b) {
    const double mean = (b.xx - a.xx + b.yy - a.yy) / 2, half = (b.xx - a.xx - b.yy + a.yy) / 2;
    const double twist = b.xy - a.xy, spread = std::hypot(half, twist);
    constexpr double crest_share = 0.5; // of the differences along a crest and square to it
    if (std::abs(std::abs(mean) - spread) > crest_share * (std::abs(mean) + spread)) return 0;
    const double slant = mean < 0 ? std::atan2(-twist, -half) / 2 : std::atan2(twist, half) / 2;
    return std::abs(slant) <= most_slant ? slant : 0;
}

/// The turn `at` between its neighbours. nullopt if the line is cut on both sides, or on one where
/// the surface continues or the end is too far away to have cut a wave.
std::optional<Ripple> ripple_between(std::span<const BendPoint> line, const Turn& before,
                                     const Turn& at, const Turn& behind, const LineEnds& ends) {
    const BendPoint &a = line[before.index], &b = line[at.index], &c = line[behind.index];
    double to_a = b.length - a.length, to_c = c.length - b.length;
    bool nearer_a = to_a < to_c;
    constexpr double slack = 1.25; // of half a wave
    if (before.cut) {
        const double rest = b.length - line.front().length;
        if (!ends.at_begin || behind.cut || rest > slack * to_c) return std::nullopt;
        to_a = to_c, nearer_a = false;
    } else if (behind.cut) {
        const double rest = line.back().length - b.length;
        if (!ends.at_end || rest > slack * to_a) return std::nullopt;
        to_c = to_a, nearer_a = true;
    }
    // Beside a dent the form may turn far away: the nearer turn is the ripple's own.
    const double width = 2 * std::min(to_a, to_c);
    const double rise = a.bend.xx - b.bend.xx, fall = c.bend.xx - b.bend.xx;
    const double swing = std::abs(rise) < std::abs(fall) ? rise : fall;
    const double depth = swing / 2 * radius_squared(width);
    const double widening = 1 + 2 * step_beside(line, at.index) / width;
    return Ripple{at.index,
                  width,
                  slant_between((nearer_a ? a : c).bend, b.bend),
                  depth,
                  std::abs(depth) * widening * widening,
                  before.cut || behind.cut};
}

} // namespace

double Ripple::square_width() const {
    return width * std::cos(slant);
}

std::vector<Ripple> find_ripples(std::span<const BendPoint> line, double depth, double window,
                                 const LineEnds& ends) {
    // The least curvature of a ripple as wide as the window.
    const std::vector<Turn> at = turns(line, depth / radius_squared(window));
    std::vector<Ripple> ripples;
    for (std::size_t i = 1; i + 1 < at.size(); ++i) {
        const auto ripple = ripple_between(line, at[i - 1], at[i], at[i + 1], ends);
        if (ripple && ripple->width <= window && ripple->deepest >= depth)
            ripples.push_back(*ripple);
    }
    return ripples;
}

} // namespace keiko
