#include "keiko/light/areas/area_penumbra.h"

#include "keiko/light/areas/area_width.h"

namespace keiko {
double visible_share(const PolygonLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options) {
    const auto width = width_of(light, point, normal);
    return width ? visible_share(*width, visible, options) : 0;
}

double visible_share(const SphereLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options) {
    const auto width = width_of(light, point, normal);
    return width ? visible_share(*width, visible, options) : 0;
}

} // namespace keiko
