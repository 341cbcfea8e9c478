#pragma once

#include "keiko/maps/texture_place.h"
#include "keiko/scene/material_map.h"

#include <cstdint>

namespace keiko {

/// The nearest two of the points of a Voronoi diagram of space, one at a random place of each cube
/// of side 1 [Worley1996].
struct VoronoiPoints {
    double nearest = 0, next = 0; ///< distances, cubes
    std::uint32_t cell = 0;       ///< random number of the nearest
};
/// The points nearest to a place; exact.
VoronoiPoints voronoi_points(const Vec3& place, std::uint32_t seed);

/// Value of a Voronoi texture, 0 to 1. Where pixels are wider than half a cube it fades to the
/// mean.
double voronoi(const TexturePlace& place, VoronoiValue value, std::uint32_t seed);

} // namespace keiko
