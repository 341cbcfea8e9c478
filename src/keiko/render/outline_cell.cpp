#include "keiko/render/outline_cell.h"

#include "keiko/render/outlines.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Of its span: how far the image of a pixel on the lamps' plane may be off a parallelogram.
constexpr double most_bend = 0.05;
/// Of the larger: by how much the cosines of a pixel may differ.
constexpr double most_turn = 0.3;

/// Whether a centre is brighter or darker than what corners show: it has seen what they have not.
bool outshines(const EyeSample& centre, const std::array<const EyeSample*, 4>& corners) {
    std::array<double, 4> shown{};
    std::transform(corners.begin(), corners.end(), shown.begin(),
                   [](const EyeSample* corner) { return luminance(corner->luminance); });
    const auto [least, most] = std::minmax_element(shown.begin(), shown.end());
    const double seen = luminance(centre.luminance), slack = 0.1 * *most;
    return seen < *least - slack || seen > *most + slack;
}

} // namespace

std::array<OutlineCell, 4> OutlineCell::quarters() const {
    const double half = side / 2;
    const auto quarter = [&](double x, double y) {
        return OutlineCell{pixel, corner + Vec2(x, y), half, depth + 1, nullptr};
    };
    return {quarter(0, 0), quarter(half, 0), quarter(0, half), quarter(half, half)};
}

bool is_uneven(std::span<const EyeSample* const> around, double across, const EyeSample& amid,
               double size) {
    double flattest = amid.cosine, steepest = amid.cosine;
    double least = amid.across_lamps, most = least;
    const bool seen = amid.c_plane.has_value();
    for (const EyeSample* sample : around) {
        flattest = std::min(flattest, sample->cosine);
        steepest = std::max(steepest, sample->cosine);
        least = std::min(least, sample->across_lamps);
        most = std::max(most, sample->across_lamps);
        if (sample->c_plane.has_value() != seen) return true; // the plane's horizon
    }
    if ((steepest - flattest) * size > most_turn * steepest) return true;
    const double span = most - least, bend = std::abs(across - amid.across_lamps);
    return seen && bend * size > most_bend * span;
}

std::vector<std::size_t> SeenCell::crossed_sides() const {
    std::vector<std::size_t> crossed;
    for (std::size_t i = 0; i < 4; ++i)
        if (differ(*corners[i], *corners[(i + 1) % 4])) crossed.push_back(i);
    return crossed;
}

CrossedSide SeenCell::side(std::size_t i) const {
    const auto places = cell.corners();
    const std::size_t end = (i + 1) % 4;
    return {i, places[i], places[end], corners[i], corners[end]};
}

bool SeenCell::looks_like(const EyeSample& sample) const {
    return std::all_of(corners.begin(), corners.end(),
                       [&](const EyeSample* corner) { return look_alike(*corner, sample); });
}

bool SeenCell::is_told_by(const EyeSample& centre) const {
    if (looks_like(centre)) return true;
    if (outshines(centre, corners)) return false;
    const auto continues_to = [&](const EyeSample* corner) { return !differ(*corner, centre); };
    double mean = 0;
    for (const EyeSample* corner : corners) mean += corner->across_lamps / 4;
    return std::any_of(corners.begin(), corners.end(), continues_to) &&
           !is_uneven(corners, mean, centre, cell.side);
}

} // namespace keiko
