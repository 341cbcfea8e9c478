#pragma once

#include "keiko/maps/texture_place.h"

#include <span>

namespace keiko {

/// Share of the pixel around a place of texture coordinates, x and y, that a polygon covers, 0 to
/// 1; exact for a pixel that is a parallelogram. The polygon is concave or not, but its outline
/// does not cross itself.
double polygon_coverage(std::span<const Vec2> corners, const TexturePlace& place);

} // namespace keiko
