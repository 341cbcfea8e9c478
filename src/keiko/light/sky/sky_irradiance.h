#pragma once

#include "keiko/geometry/rays/visibility.h"
#include "keiko/light/penumbra/width_share.h"
#include "keiko/light/sky/sky_panels.h"

namespace keiko {

/// Illuminance in lx of a surface with unit `normal` below a whole sky of 1 cd/m2 at the zenith,
/// past no body and without the ground. In closed form (docs/theory/sky.md#closed-forms), or, if
/// the sky is clear, by quadrature to 1e-6.
double unobstructed_illuminance(const SkyLight& sky, const Vec3& normal);

/// Illuminance in lx from a panel of a sky, past no body, at `point` with unit `normal`; colour
/// included. In closed form, or, if the sky is clear, by quadrature to 1e-6.
Rgb illuminance_from(const SkyLight& sky, const SkyPanel& panel, const Vec3& point,
                     const Vec3& normal);

/// About the share of a panel in the light that an open sky and its ground bring past no body, both
/// being taken as even: by solid angles. A quarter of a clear sky, which is far from even, where
/// there are windows, and where there is no light at all.
double panel_share(const SkyLight& sky, const SkyPanel& panel, const Vec3& point,
                   const Vec3& normal);

/// Visible share, 0 to 1, of that illuminance: past bodies, and without the directions that windows
/// before the panel's own show as well; 1 if the panel sends no light.
double visible_share(const SkyLight& sky, const SkyPanel& panel, const Vec3& point,
                     const Vec3& normal, const Visibility& visible, const WidthOptions& options);

} // namespace keiko
