#pragma once

#include "keiko/base/export.h"
#include "keiko/math/bounds.h"
#include "keiko/scene/camera.h"

#include <optional>

namespace KEIKO_API keiko {

/// Two eyes beside the eye of a camera, and the screen that shows what both see. The screen is
/// perpendicular to the view: eyes that turn towards each other would see it tilted, with vertical
/// disparities [Woods1993].
struct Stereo {
    double eye_distance = 65; ///< mm between both eyes, above 0
    /// mm along the view, above 0: what is so far away has no parallax; by default the target's
    /// distance
    std::optional<double> screen_distance{};
};

/// The cameras of both eyes. Their pictures lie on the same part of the screen.
struct StereoPair {
    Camera left, right; ///< with parallel axes, and shifts that are opposite
};

/// The eyes of a perspective camera. Throws FieldError for an orthographic one, and for a distance
/// that is not above 0.
StereoPair stereo_pair(const Camera& camera, const Stereo& stereo);

/// mm on the screen by which the right eye sees a point further right than the left one. `depth`:
/// mm from the eyes along the view, above 0. Points before the screen have a negative one.
double stereo_parallax(const Camera& camera, const Stereo& stereo, double depth);

/// The parallax of largest size of what a box holds, mm; -infinity if the box reaches beside or
/// behind the eyes.
double largest_parallax(const Camera& camera, const Stereo& stereo, const Box3& box);

} // namespace keiko
