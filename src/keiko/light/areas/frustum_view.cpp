#include "keiko/light/areas/frustum_view.h"

#include "keiko/math/axes.h"

#include <cmath>
#include <numbers>

namespace keiko {

/// A generator faces the point if the point is before its tangent plane. This cuts the plane across
/// the axis through the point in a tangent of the circle that the whole cone, beyond its ends, is
/// there. Beyond the apex its radius is negative.
std::optional<FrustumView> FrustumView::of(const FrustumLight& light, const Vec3& point) {
    FrustumView view{light.from - point, light.to - point, light.radius, light.to_radius,
                     light.along()};
    const double height = -view.along.dot(view.from);
    const Vec3 off = -view.from - view.along * height;
    const double distance = off.length();
    view.nearest = distance > 0 ? off / distance : any_perpendicular(view.along).normalized();
    view.beside = view.along.cross(view.nearest);
    const double share = height / (light.to - light.from).length();
    const double radius = light.radius + (light.to_radius - light.radius) * share;
    if (!(radius < distance)) return std::nullopt;
    view.half = radius > -distance ? std::acos(radius / distance) : std::numbers::pi;
    return view;
}

Vec3 FrustumView::outwards(double angle) const {
    return nearest * std::cos(angle) + beside * std::sin(angle);
}

bool FrustumView::all_around() const {
    return half == std::numbers::pi;
}

} // namespace keiko
