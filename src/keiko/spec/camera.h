#pragma once

#include "keiko/math/bounds.h"
#include "keiko/patch/ray.h"

namespace keiko {

enum class Projection { perspective, orthographic };

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
    /// centre of the upper left pixel; with differentials per pixel.
    Ray ray(double x, double y) const;
    /// Solid angle of the pixel at (x, y) in sr; for orthographic cameras the same for all: 1.
    double pixel_solid_angle(double x, double y) const;
};

} // namespace keiko
