#include "keiko/maps/panorama.h"

#include <array>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// Axes of a face of a cube map: outwards, along s, and along t.
struct CubeAxes {
    Vec3 out, s, t;
};
const std::array<CubeAxes, 6>& cube_axes() {
    static const std::array<CubeAxes, 6> axes{{
        {{1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
        {{-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
        {{0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
        {{0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
        {{0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
        {{0, 0, -1}, {-1, 0, 0}, {0, -1, 0}},
    }};
    return axes;
}

std::size_t cube_face(const Vec3& d) {
    const Vec3 size = magnitudes(d);
    const int axis = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    return static_cast<std::size_t>(2 * axis + (d[axis] < 0 ? 1 : 0));
}

} // namespace

ProjectedPlace lat_long_place(const Vec3& direction) {
    const MapProjection about_zenith{.kind = ProjectionKind::spherical};
    return projected(about_zenith, direction);
}

CubePlace cube_place(const Vec3& direction) {
    const std::size_t face = cube_face(direction);
    const auto& [out, s, t] = cube_axes()[face];
    const double depth = direction.dot(out);
    const Vec2 at(direction.dot(s) / depth, direction.dot(t) / depth);
    return {face,
            {(at + Vec2(1)) / 2.0, (s - out * at.x) / (2 * depth), (t - out * at.y) / (2 * depth)}};
}

Vec3 lat_long_direction(const Vec2& place) {
    const double phi = 2 * std::numbers::pi * place.x, theta = std::numbers::pi * place.y;
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

Vec3 cube_direction(std::size_t face, const Vec2& place) {
    const auto& [out, s, t] = cube_axes()[face];
    return (out + s * (2 * place.x - 1) + t * (2 * place.y - 1)).normalized();
}

double lat_long_solid_angle(int width, int height, int row) {
    const double step = std::numbers::pi / height, middle = (row + 0.5) * step;
    // The difference of the cosines at the row's borders, which cancels in high pictures.
    return 2 * std::numbers::pi / width * 2 * std::sin(middle) * std::sin(step / 2);
}

double cube_solid_angle(const Vec2& place) {
    const Vec2 p = place * 2.0 - Vec2(1);
    return 4 / std::pow(1 + p.length2(), 1.5);
}

} // namespace keiko
