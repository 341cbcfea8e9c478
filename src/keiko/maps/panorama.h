#pragma once

#include "keiko/maps/projection.h"
#include "keiko/math/vec.h"
#include "keiko/scene/environment_spec.h"

#include <cstddef>

namespace keiko {

/// Place of a direction in one square picture of a cube map, in the order and with the signs of
/// OpenGL: +x, -x, +y, -y, +z, -z. Its coordinates are 0 to 1, s to the right and t down.
struct CubePlace {
    std::size_t face = 0; ///< 0 to 5
    ProjectedPlace at{};  ///< s and t, and their gradients by the direction
};

/// Place of a direction, of any length but 0, on a panorama. u is 0 at +x and rises anticlockwise
/// as viewed from above. v is 0 at the zenith and 1 at the nadir.
ProjectedPlace lat_long_place(const Vec3& direction);
/// Place of a direction, of any length but 0, on a cube map.
CubePlace cube_place(const Vec3& direction);

/// Unit direction of a place of a panorama.
Vec3 lat_long_direction(const Vec2& place);
/// Unit direction of a place of a face of a cube map.
Vec3 cube_direction(std::size_t face, const Vec2& place);

/// sr, solid angle of each pixel in a row of a panorama of a size.
double lat_long_solid_angle(int width, int height, int row);
/// sr per s and t, solid angle of a place of a cube map.
double cube_solid_angle(const Vec2& place);

} // namespace keiko
