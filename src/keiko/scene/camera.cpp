#include "keiko/scene/camera.h"

#include "keiko/base/units.h"
#include "keiko/scene/prepared_camera.h"

#include <cmath>

namespace keiko {
namespace {

/// Sine of the angle to the view direction below which `up` says nothing.
constexpr double parallel = 1e-9;

/// Position on the picture plane, in its own unit (see Camera::pixel_size), right and up.
Vec2 plane_position(const Camera& camera, double x, double y) {
    return Vec2(x - camera.width / 2.0, camera.height / 2.0 - y) * camera.pixel_size();
}

} // namespace

CameraAxes Camera::axes() const {
    const Vec3 forward = (target - eye).normalized();
    Vec3 right;
    for (const Vec3& candidate : {up.normalized(), Vec3(0, 0, 1), Vec3(0, 1, 0)}) {
        right = forward.cross(candidate);
        if (right.length() > parallel) break;
    }
    right.normalize();
    return {right, right.cross(forward), forward};
}

double Camera::pixel_size() const {
    const double plane_height = projection == Projection::orthographic
                                    ? orthographic_height
                                    : 2 * std::tan(degrees_to_radians(vertical_fov) / 2);
    return plane_height / height;
}

Ray Camera::ray(double x, double y) const {
    return PreparedCamera(*this).ray(x, y);
}

double Camera::pixel_solid_angle(double x, double y) const {
    if (projection == Projection::orthographic) return 1;
    const double squared = 1 + plane_position(*this, x, y).length2();
    return pixel_size() * pixel_size() / (squared * std::sqrt(squared));
}

std::optional<Vec2> project(const Camera& camera, const Vec3& point) {
    return PreparedCamera(camera).project(point);
}

} // namespace keiko
