#include "keiko/light/areas/area_penumbra.h"

#include "keiko/light/areas/area_width.h"
#include "keiko/light/areas/contour_width.h"
#include "keiko/light/areas/ellipse_width.h"
#include "keiko/light/areas/frustum_width.h"

namespace keiko {
namespace {

template <AreaLight Light>
double share_of(const Light& light, const Vec3& point, const Vec3& normal,
                const Visibility& visible, const WidthOptions& options) {
    const auto width = width_of(light, point, normal);
    return width ? visible_share(*width, visible, options) : 0;
}

Prism prism_of(const Box3& box) {
    Prism prism;
    for (unsigned i = 0; i < prism.size(); ++i) {
        const double y = i % 2 ? box.upper.y : box.lower.y, z = i / 2 ? box.upper.z : box.lower.z;
        prism[i] = {Vec3(box.lower.x, y, z), Vec3(box.upper.x, y, z)};
    }
    return prism;
}

} // namespace

double visible_share(const PolygonLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options) {
    return share_of(light, point, normal, visible, options);
}

double visible_share(const SphereLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options) {
    return share_of(light, point, normal, visible, options);
}

double visible_share(const DiscLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options) {
    return share_of(light, point, normal, visible, options);
}

double visible_share(const FrustumLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options) {
    return share_of(light, point, normal, visible, options);
}

double visible_share(const EllipsoidLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options) {
    return share_of(light, point, normal, visible, options);
}

double visible_share(const ContourLight& light, const Vec3& point, const Vec3& normal,
                     const Visibility& visible, const WidthOptions& options) {
    const Prism around = prism_of(light.body->bounds());
    if (const auto whole = visible.classify_prisms({&around, 1}).front()) return *whole ? 1 : 0;
    double all = 0, seen = 0;
    const std::vector<ContourWidth> widths =
        ContourWidth::all(light, point, normal, options.tolerance);
    for (const ContourWidth& width : widths) {
        const double share = visible_share(width, VisibleFront(width, visible), options);
        if (widths.size() == 1) return share;
        const double own = projected_solid_angle(width, options.tolerance);
        all += own, seen += own * share;
    }
    return all > 0 ? seen / all : 0;
}

} // namespace keiko
