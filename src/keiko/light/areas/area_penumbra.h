#pragma once

#include "keiko/light/areas/area_lights.h"
#include "keiko/light/penumbra/width_share.h"

namespace keiko {

/// Visible share, 0 to 1, of the projected solid angle of an area light above the horizon of
/// `point` with unit `normal`. 0 for a source that sends no light there. One ray suffices if the
/// whole source is proved to have one visibility. Otherwise visible parts of lines across it are
/// integrated until the estimated error is below the tolerance (docs/theory/areas.md#shadows).
double visible_share(const PolygonLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options);
double visible_share(const SphereLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options);
double visible_share(const DiscLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options);
double visible_share(const FrustumLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options);
double visible_share(const EllipsoidLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options);
double visible_share(const ContourLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options);

} // namespace keiko
