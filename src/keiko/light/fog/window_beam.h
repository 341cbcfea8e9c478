#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/fog/transmittance.h"

#include <optional>
#include <vector>

namespace keiko {

/// A plane polygon that lets parallel light in; it may be concave, and turn either way.
struct Window {
    std::vector<Vec3> corners; ///< mm, at least 3

    bool operator==(const Window&) const = default;
};

/// Normal of the polygon, of any length [Sutherland1974]: not that of a polygon without area.
Vec3 window_normal(const Window& window);

/// How far, in mm, light of a unit `direction` went past the window to a point; nothing where it
/// did not come through the window.
std::optional<double> way_from_window(const Window& window, const Vec3& direction,
                                      const Vec3& point);

/// Parts of a segment in the prism that parallel light fills behind a window
/// (docs/theory/fog.md#lit-parts).
IntervalSet in_window_beam(const Window& window, const Vec3& direction, const Segment& segment);

/// Parallel light behind a window, as the medium sees it.
struct ParallelBeam {
    Vec3 direction{0, 0, -1}; ///< unit, the way the light goes
    Rgb illuminance{0};       ///< lx across the light at the window
    const Window& window;
};

/// Luminance in cd/m2 that the beam, scattered once in the `lit` parts of a camera ray, adds at the
/// eye, dimmed from the window on. In closed form where the medium is uniform
/// (docs/theory/fog.md#the-integral), else by Gauss quadrature refined to `tolerance`.
Rgb scattered_light(const AttenuatedRay& camera_ray, const IntervalSet& lit,
                    const ParallelBeam& beam, double tolerance = 1e-8);

} // namespace keiko
