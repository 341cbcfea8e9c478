#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/light/fog/transmittance.h"

#include <optional>
#include <vector>

namespace KEIKO_API keiko {

/// A plane polygon that lets parallel light in; it may be concave, and of either orientation.
struct Window {
    std::vector<Vec3> corners; ///< mm, at least 3

    bool operator==(const Window&) const = default;
};

/// Distance, in mm, that light of a unit `direction` travels from the window to a point; nullopt if
/// it does not come through the window.
std::optional<double> way_from_window(const Window& window, const Vec3& direction,
                                      const Vec3& point);

/// Parts of a segment in the prism that parallel light fills behind a window
/// (docs/theory/fog.md#lit-parts).
IntervalSet in_window_beam(const Window& window, const Vec3& direction, const Segment& segment);

/// Parallel light behind a window, for the medium.
struct ParallelBeam {
    Vec3 direction{0, 0, -1}; ///< unit, direction of the light
    Rgb illuminance{0};       ///< lx across the light at the window
    const Window& window;     ///< that the light comes in through
};

/// Luminance in cd/m2 that the beam, scattered once in the `lit` parts of a camera ray, adds at the
/// camera, attenuated from the window on. It is computed in closed form if the medium is uniform
/// (docs/theory/fog.md#the-integral), else by Gauss quadrature refined to `tolerance`.
Rgb scattered_light(const AttenuatedRay& camera_ray, const IntervalSet& lit,
                    const ParallelBeam& beam, double tolerance = 1e-8);

} // namespace keiko
