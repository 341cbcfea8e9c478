#include "keiko/light/areas/ellipse_width.h"

#include "keiko/math/axes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;
/// Angle, rad, under which a plane must be viewed for its light to be more than rounding.
constexpr double edge_on = 1e-9;

} // namespace

std::optional<EllipseWidth> EllipseWidth::of(const DiscLight& light, const Vec3& point,
                                             const Vec3& normal) {
    if (!light.shines_at(point)) return std::nullopt;
    return of(light, outline_ellipse(light, point), point, normal);
}

std::optional<EllipseWidth> EllipseWidth::of(const SphereLight& light, const Vec3& point,
                                             const Vec3& normal) {
    if (!((light.center - point).length() > light.radius)) return std::nullopt;
    return of(light, outline_ellipse(light, point), point, normal);
}

std::optional<EllipseWidth> EllipseWidth::of(const EllipsoidLight& light, const Vec3& point,
                                             const Vec3& normal) {
    if (!light.shines_at(point)) return std::nullopt;
    return of(light, outline_ellipse(light, point), point, normal);
}

std::optional<EllipseWidth> EllipseWidth::of(const Light& light, const Ellipse& outline,
                                             const Vec3& point, const Vec3& normal) {
    const Vec3 way = point - outline.center;
    Vec3 facing = outline.normal().normalized();
    if (facing.dot(way) < 0) facing = -facing;
    if (!(facing.dot(way) > edge_on * way.length())) return std::nullopt;
    const Vec3 level = facing.cross(normal);
    const Vec3 along = level.length() > edge_on ? level : any_perpendicular(facing);
    EllipseWidth width(light, outline, facing, along.normalized(), point, normal);
    if (!(width.half_ > 0)) return std::nullopt;
    return width;
}

EllipseWidth::EllipseWidth(const Light& light, const Ellipse& outline, const Vec3& plane_normal,
                           const Vec3& along, const Vec3& point, const Vec3& normal)
    : AreaWidth(outline.center, plane_normal, along, point, normal),
      light_(light),
      center_(place_of(outline.center)) {
    const Vec2 p = place_of(outline.center + outline.p) - center_;
    const Vec2 q = place_of(outline.center + outline.q) - center_;
    // Conjugate half-diameters again, but one along the lines.
    high_ = std::hypot(p.y, q.y);
    aslant_ = (p.x * p.y + q.x * q.y) / high_;
    wide_ = std::abs(p.cross(q)) / high_;
    const double reach = std::hypot(wide_, aslant_);
    set_extent({center_.x - reach, center_.x + reach});
    // The horizon runs along the lines. It is met where elevation({0, v}) is 0.
    const double slope = n_across() * high_;
    const double height = n_ahead() * distance() + n_across() * center_.y;
    const double horizon = std::abs(slope) > 0 ? -height / std::abs(slope) : height > 0 ? -1 : 1;
    const double lowest = std::asin(std::clamp(horizon, -1.0, 1.0));
    middle_ = (lowest + pi / 2) / 2 * (slope < 0 ? -1 : 1);
    half_ = (pi / 2 - lowest) / 2;
}

SubAxis EllipseWidth::sub_axis(double place) const {
    const double angle = middle_ + half_ * place, v = center_.y + high_ * std::sin(angle);
    const double r2 = distance() * distance() + v * v;
    return line_at(v, half_ * high_ * std::cos(angle) * distance() / r2);
}

double EllipseWidth::place_in(const Vec3& way) const {
    const double psi = wedge_angle(way);
    const double sine = (distance() * std::tan(psi) - center_.y) / high_;
    if (!(std::abs(psi) < pi / 2)) return std::copysign(2, psi);
    if (!(std::abs(sine) < 1)) return std::copysign(2, sine);
    return (std::asin(sine) - middle_) / half_;
}

Vec3 EllipseWidth::place(const SubAxis& axis, double half_tangent) const {
    const Vec3 way = direction(axis, half_tangent);
    const double t =
        std::visit([&](const auto& light) { return entry_of(light, point(), way); }, light_);
    return point() + way * t;
}

std::vector<ParameterInterval> EllipseWidth::chords(double v) const {
    const double up = v - center_.y;
    const double half = wide_ / high_ * std::sqrt(std::max(0.0, (high_ - up) * (high_ + up)));
    const double middle = center_.x + aslant_ / high_ * up;
    return {{middle - half, middle + half}};
}

} // namespace keiko
