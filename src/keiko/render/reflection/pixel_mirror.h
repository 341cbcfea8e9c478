#pragma once

#include "keiko/geometry/rays/ray.h"
#include "keiko/light/rig/rig_planes.h"
#include "keiko/render/reflection/reflected_footprint.h"

#include <optional>

namespace keiko {

/// Largest bend of the image of a pixel, or of a part of one, that counts as straight: ImageBend.
constexpr double straight_image = 0.01;
/// True if the reflection is discontinuous across the pixel: the neighbours' rays miss the pixel's
/// cubic by `residual` mm > 10 % of the lamp pitch. A residual > 2 % of the pitch suffices if it is
/// > 5 % of the image's span across the lamps by the centre's `spread`.
bool is_discontinuous(double residual, const RigPlaneHit& plane, const RayDifferentials& spread);
/// Number of parts a side for a pixel whose image has this bend, 1 to 8; 8 if the bend is NaN. Not
/// for negative ones.
int parts_of_bend(double bend);

/// Lamps visible in a pixel by its reflected rays.
struct PixelMirror {
    MirroredLight lamps;              ///< mean over the pixel
    std::optional<RigPlaneHit> plane; ///< the nearest that the centre's ray meets
    /// True if its image on a C-plane is not smooth: more camera rays are needed.
    bool discontinuous = false;
};

/// Lamps in a pixel by `centre`, the ray of its centre; they are visible up to `t_max`. If the
/// pixel's image on a C-plane is bent, by `around`, it is the mean over as many parts as make each
/// nearly straight. `tells_torn`: whether to detect discontinuities.
PixelMirror mirror_of(const RigPlanes& planes, const Ray& centre,
                      const std::optional<PixelRays>& around, double t_max, bool tells_torn);

} // namespace keiko
