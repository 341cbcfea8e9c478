#include "keiko/scene/stereo.h"

#include "keiko/base/error.h"

#include <cmath>
#include <limits>

namespace keiko {
namespace {

double screen_distance(const Camera& camera, const Stereo& stereo) {
    return stereo.screen_distance.value_or((camera.target - camera.eye).length());
}

/// The eye that is `aside` mm to the right. Its middle ray is parallel to that of the camera, so
/// that the middle of the screen lies aside of it.
Camera eye_aside(const Camera& camera, double aside, double screen) {
    Camera eye = camera;
    const Vec3 offset = camera.axes().right * aside;
    eye.eye += offset, eye.target += offset;
    eye.shift.x += aside / (screen * camera.pixel_size());
    return eye;
}

} // namespace

StereoPair stereo_pair(const Camera& camera, const Stereo& stereo) {
    if (camera.projection == Projection::orthographic)
        throw FieldError("projection", "an orthographic camera has no eye to put two beside");
    const double screen = screen_distance(camera, stereo);
    if (!(screen > 0)) throw FieldError("screen_distance", "must be above 0");
    if (!(stereo.eye_distance > 0)) throw FieldError("eye_distance", "must be above 0");
    return {eye_aside(camera, -stereo.eye_distance / 2, screen),
            eye_aside(camera, stereo.eye_distance / 2, screen)};
}

double stereo_parallax(const Camera& camera, const Stereo& stereo, double depth) {
    return stereo.eye_distance * (1 - screen_distance(camera, stereo) / depth);
}

double largest_parallax(const Camera& camera, const Stereo& stereo, const Box3& box) {
    const Vec3 forward = camera.axes().forward, half = box.extent() * 0.5;
    const double middle = (box.center() - camera.eye).dot(forward);
    const double reach =
        std::abs(half.x * forward.x) + std::abs(half.y * forward.y) + std::abs(half.z * forward.z);
    if (!(middle > reach)) return -std::numeric_limits<double>::infinity();
    const double nearest = stereo_parallax(camera, stereo, middle - reach);
    const double farthest = stereo_parallax(camera, stereo, middle + reach);
    return std::abs(nearest) > std::abs(farthest) ? nearest : farthest;
}

} // namespace keiko
