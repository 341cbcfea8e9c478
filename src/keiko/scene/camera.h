#pragma once

#include "keiko/geometry/bezier/ray.h"
#include "keiko/math/bounds.h"

#include <optional>

namespace keiko {

enum class Projection { perspective, orthographic };

/// Unit axes of a picture in space; right x up = -forward.
struct CameraAxes {
    Vec3 right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
};

/// The eye of a picture. Lengths in mm, angles in degrees, pixel (0, 0) at the upper left.
struct Camera {
    Projection projection = Projection::perspective;
    Vec3 eye{3000, -2500, 1400};
    Vec3 target{0, 0, 600};
    Vec3 up{0, 0, 1};
    double vertical_fov = 28;       ///< degrees; perspective only
    double orthographic_height = 0; ///< mm across the picture's height; orthographic only
    int width = 960, height = 540;

    /// Ray with unit direction through the picture point (x, y) in pixels, (0.5, 0.5) being the
    /// centre of the upper left pixel; with differentials per pixel. For many rays: PreparedCamera.
    Ray ray(double x, double y) const;
    /// Solid angle of the pixel at (x, y) in sr; for orthographic cameras the same for all: 1.
    double pixel_solid_angle(double x, double y) const;
    /// The axes of the picture. Where `up` is along the view direction, another axis of space
    /// takes its place.
    CameraAxes axes() const;
    /// Edge of a pixel: mm for orthographic cameras, else a length on the picture plane at
    /// distance 1 from the eye.
    double pixel_size() const;

    bool operator==(const Camera&) const = default;
};

/// Picture position in pixels of a point in space, inside the picture or not; nothing for points
/// beside or behind the eye of a perspective camera.
std::optional<Vec2> project(const Camera& camera, const Vec3& point);

} // namespace keiko
