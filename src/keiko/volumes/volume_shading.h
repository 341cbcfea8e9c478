#pragma once

#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"
#include "keiko/scene/volume_spec.h"

namespace keiko {

/// Unit normal out of the dense part, against the gradient; 0 where that vanishes.
Vec3 volume_normal(const Vec3& gradient);

/// Part of Phong's sum that depends on the normal, with Blinn's highlight
/// (docs/theory/volumes.md#shading): `diffuse` of the body's own colour and `specular` of the
/// light's. All directions are unit ones.
struct ShadingTerms {
    double diffuse = 0, specular = 0; ///< factors of the light's luminance
};
/// Terms at a normal, or 0, under a light and towards a viewer.
ShadingTerms shading_terms(const VolumeShading& shading, const Vec3& normal, const Vec3& to_light,
                           const Vec3& to_viewer);

/// cd/m2 of a place of this colour, `distance` mm from the viewer.
Rgb shaded_luminance(const VolumeShading& shading, const ShadingTerms& terms, const Rgb& color,
                     double distance);

} // namespace keiko
