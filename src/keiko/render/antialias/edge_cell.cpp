#include "keiko/render/antialias/edge_cell.h"

#include "keiko/render/antialias/edge_detection.h"

#include <algorithm>

namespace keiko {
namespace {

/// Of the larger luminance: what a pixel may be off.
constexpr double least_contrast = 0.01;

/// How far two samples are from showing one plane.
double change(const PixelSample& a, const PixelSample& b) {
    constexpr double outline = 4; // more than any turn
    if (differ_closely(a, b)) return outline;
    return a.hit ? a.hit->normal.cross(b.hit->normal).length() : 0;
}

} // namespace

std::array<EdgeCell, 2> EdgeCell::halves(unsigned axis) const {
    Vec2 step(0), half = size;
    half[axis] /= 2;
    step[axis] = half[axis];
    return {EdgeCell{pixel, corner, half, nullptr}, EdgeCell{pixel, corner + step, half, nullptr}};
}

SeenCell::SeenCell(const EdgeCell& seen, std::span<const PixelSample* const, 4> around)
    : cell(seen) {
    std::copy(around.begin(), around.end(), corners.begin());
    for (std::size_t i = 0; i < 4; ++i)
        if (differ_closely(*corners[i], *corners[(i + 1) % 4])) crossed_sides.push_back(i);
}

EdgeCrossing SeenCell::side(std::size_t i) const {
    const auto places = cell.corners();
    const std::size_t end = (i + 1) % 4;
    return {i, places[i], places[end], corners[i], corners[end]};
}

bool SeenCell::looks_like(const PixelSample& sample) const {
    const double contrast = least_contrast / cell.area();
    return std::all_of(corners.begin(), corners.end(), [&](const PixelSample* corner) {
        return look_alike(*corner, sample, contrast) && !differ(*corner, sample);
    });
}

SampledPolygon SeenCell::part() const {
    SampledPolygon part;
    for (const Vec2& place : cell.corners()) part.corners.push_back(place);
    for (const PixelSample* corner : corners) part.seen.push_back(corner);
    return part;
}

unsigned SeenCell::most_varied_axis(double finest) const {
    const Vec2& size = cell.size;
    if (!(size.x > finest)) return 1;
    if (!(size.y > finest)) return 0;
    const double across = change(*corners[0], *corners[1]) + change(*corners[3], *corners[2]);
    const double down = change(*corners[0], *corners[3]) + change(*corners[1], *corners[2]);
    if (across == down) return size.y > size.x ? 1 : 0;
    return down > across ? 1 : 0;
}

} // namespace keiko
