#include "keiko/inspect/ripple.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Indices of largest and smallest values in turn, between which the values change by more than
/// `swing`; what comes before the first such change and after the last is none.
std::vector<std::size_t> turns(std::span<const LinePoint> line, double swing) {
    std::vector<std::size_t> found;
    std::size_t high = 0, low = 0;
    int direction = 0;
    for (std::size_t i = 0; i < line.size(); ++i) {
        if (line[i].bend > line[high].bend) high = i;
        if (line[i].bend < line[low].bend) low = i;
        if (direction >= 0 && line[high].bend - line[i].bend > swing) {
            if (direction > 0) found.push_back(high);
            direction = -1, low = i;
        } else if (direction <= 0 && line[i].bend - line[low].bend > swing) {
            if (direction < 0) found.push_back(low);
            direction = 1, high = i;
        }
    }
    return found;
}

} // namespace

std::vector<Ripple> find_ripples(std::span<const LinePoint> line, double depth, double window) {
    const auto radius_squared = [](double width) {
        return width * width / (4 * std::numbers::pi * std::numbers::pi);
    };
    // The least that a ripple as wide as the window has.
    const std::vector<std::size_t> at = turns(line, depth / radius_squared(window));
    std::vector<Ripple> ripples;
    for (std::size_t i = 1; i + 1 < at.size(); ++i) {
        const LinePoint &a = line[at[i - 1]], &b = line[at[i]], &c = line[at[i + 1]];
        // Beside a dent the form may turn far off: the nearer turn is the ripple's own.
        const double width = 2 * std::min(b.length - a.length, c.length - b.length);
        const double rise = a.bend - b.bend, fall = c.bend - b.bend;
        const double swing = std::abs(rise) < std::abs(fall) ? rise : fall;
        const double found = swing / 2 * radius_squared(width);
        if (width <= window && std::abs(found) >= depth) ripples.push_back({at[i], width, found});
    }
    return ripples;
}

} // namespace keiko
