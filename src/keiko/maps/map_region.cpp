#include "keiko/maps/map_region.h"

#include "keiko/math/convex_clip.h"
#include "keiko/math/polygon.h"

#include <vector>

namespace keiko {
namespace {

double area(std::span<const Vec2> corners) {
    double twice = 0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        twice += corners[i].cross(corners[i + 1 < corners.size() ? i + 1 : 0]);
    return std::abs(twice) / 2;
}

/// The part of a polygon in the square of side 1 about 0. Where a concave polygon falls apart, its
/// pieces hang together by lines without area.
std::vector<Vec2> in_unit_square(std::vector<Vec2> corners) {
    for (const int axis : {0, 1})
        for (const double side : {-1.0, 1.0}) {
            std::vector<Vec2> part;
            clip_convex(
                corners, [&](std::size_t i) { return 0.5 - side * corners[i][axis]; },
                [&](const Vec2& corner) { part.push_back(corner); });
            corners = std::move(part);
        }
    return corners;
}

} // namespace

double polygon_coverage(std::span<const Vec2> corners, const TexturePlace& place) {
    const Vec2 at(place.at.x, place.at.y), x(place.dx.x, place.dx.y), y(place.dy.x, place.dy.y);
    const double size = x.cross(y);
    constexpr double flat = 1e-9; // sine between the pixel's sides: its area says nothing
    if (!(std::abs(size) > flat * x.length() * y.length())) return holds(corners, at) ? 1 : 0;
    std::vector<Vec2> in_pixel;
    in_pixel.reserve(corners.size());
    for (const Vec2& corner : corners) {
        const Vec2 off = corner - at;
        in_pixel.emplace_back(off.cross(y) / size, x.cross(off) / size);
    }
    return std::min(area(in_unit_square(std::move(in_pixel))), 1.0);
}

} // namespace keiko
