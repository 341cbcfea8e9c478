#include "keiko/placement/mirrored_lamps.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr double rounding = 1e-9; ///< of a unit vector, and of a length

bool lies_along(const Vec3& direction, const MirrorPlane& mirror) {
    return std::abs(direction[mirror.axis]) < rounding;
}
bool is_square_to(const Vec3& direction, const MirrorPlane& mirror) {
    return std::abs(std::abs(direction[mirror.axis]) - 1) < rounding;
}

} // namespace

bool is_own_image(const PlaneFrame& frame, const MirrorPlane& mirror) {
    return (is_square_to(frame.u, mirror) && lies_along(frame.v, mirror)) ||
           (is_square_to(frame.v, mirror) && lies_along(frame.u, mirror));
}

PlaneFrame image_of(const PlaneFrame& frame, const MirrorPlane& mirror) {
    return {mirror.image(frame.origin), mirror.image_of_direction(frame.u),
            mirror.image_of_direction(frame.v)};
}

Box2 symmetric_extent(const PlaneFrame& frame, const Box2& extent, const MirrorPlane& mirror) {
    const int across = is_square_to(frame.u, mirror) ? 0 : 1;
    const Vec3& direction = across == 0 ? frame.u : frame.v;
    const double middle = -mirror.distance(frame.origin) / direction[mirror.axis];
    const double half =
        std::max(std::abs(extent.lower[across] - middle), std::abs(extent.upper[across] - middle));
    Box2 symmetric = extent;
    symmetric.lower[across] = middle - half, symmetric.upper[across] = middle + half;
    return symmetric;
}

bool is_own_image(const Camera& camera, const MirrorPlane& mirror) {
    const CameraAxes axes = camera.axes();
    const double distance = (camera.target - camera.eye).length();
    return std::abs(mirror.distance(camera.eye)) < rounding * distance &&
           lies_along(axes.forward, mirror) &&
           (is_square_to(axes.right, mirror) || is_square_to(axes.up, mirror));
}

} // namespace keiko
