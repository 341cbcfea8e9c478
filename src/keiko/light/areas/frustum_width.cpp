#include "keiko/light/areas/frustum_width.h"

#include "keiko/light/luminance/elevations.h"
#include "keiko/light/luminance/flush.h"
#include "keiko/math/axes.h"
#include "keiko/math/bounds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;

/// Angles from -pi to pi at which a + b cos + c sin is 0.
std::vector<double> zeros_of(double a, double b, double c) {
    const double swing = std::hypot(b, c);
    if (!(std::abs(a) < swing)) return {};
    const double highest = std::atan2(c, b), half = std::acos(-a / swing);
    return {std::remainder(highest - half, 2 * pi), std::remainder(highest + half, 2 * pi)};
}

} // namespace

std::optional<FrustumWidth> FrustumWidth::of(const FrustumLight& light, const Vec3& point,
                                             const Vec3& normal) {
    const auto view = FrustumView::of(light, point);
    if (!view) return std::nullopt;
    // To the apex, times the difference of the radii, which may be 0 or less.
    const Vec3 pole =
        view->from * (view->radius - view->to_radius) + (view->to - view->from) * view->radius;
    constexpr double nothing = 1e-12;
    const double reach = std::max(view->from.length(), view->to.length());
    if (!(pole.length() > nothing * reach * std::max(view->radius, view->to_radius)))
        return std::nullopt;
    return FrustumWidth(*view, pole.normalized(), point, normal);
}

FrustumWidth::FrustumWidth(const FrustumView& view, const Vec3& pole, const Vec3& point,
                           const Vec3& normal)
    : view_(view), pole_(pole), point_(point), normal_(normal) {
    const Vec3 nearest = middle(0);
    const Vec3 level = nearest - pole_ * pole_.dot(nearest);
    ahead_ = level.length() > 0 ? level.normalized() : any_perpendicular(pole_).normalized();
    across_ = pole_.cross(ahead_);
    turn_ = pole_.dot(middle(0).cross(view_.beside)) < 0 ? -1 : 1;
}

Vec3 FrustumWidth::middle(double angle) const {
    return (view_.on_rim(angle) + view_.on_to_rim(angle)) / 2;
}

SubAxis FrustumWidth::sub_axis(double place) const {
    const double angle = angle_at(place), radius = (view_.radius + view_.to_radius) / 2;
    const Vec3 at = middle(angle);
    const Vec3 change = (view_.beside * std::cos(angle) - view_.nearest * std::sin(angle)) * radius;
    const double x = ahead_.dot(at), y = across_.dot(at), r = std::hypot(x, y);
    const double rate = std::abs(pole_.dot(at.cross(change))) / (r * r);
    return {x / r, y / r, r, rate * view_.half, place};
}

Segment FrustumWidth::line_of(const SubAxis& axis) const {
    const double angle = angle_at(axis.place);
    return {point_ + view_.on_rim(angle) * (1 - flush),
            point_ + view_.on_to_rim(angle) * (1 - flush)};
}

Prism FrustumWidth::around() const {
    Box3 box; // along the pole and across it
    const auto add = [&](const Vec3& center, double radius) {
        const auto reach = [&](const Vec3& axis) {
            const double cosine = axis.dot(view_.along);
            return radius * std::sqrt(std::max(0.0, (1 - cosine) * (1 + cosine)));
        };
        const Vec3 at(pole_.dot(center), ahead_.dot(center), across_.dot(center));
        const Vec3 half(reach(pole_), reach(ahead_), reach(across_));
        box.extend(at - half);
        box.extend(at + half);
    };
    add(view_.from, view_.radius);
    add(view_.to, view_.to_radius);
    const auto edge = [&](double x, double y) {
        const Vec3 off = point_ + ahead_ * x + across_ * y;
        return Segment{off + pole_ * box.lower.x, off + pole_ * box.upper.x};
    };
    return {edge(box.lower.y, box.lower.z), edge(box.upper.y, box.lower.z),
            edge(box.lower.y, box.upper.z), edge(box.upper.y, box.upper.z)};
}

Vec3 FrustumWidth::level(const SubAxis& axis) const {
    return ahead_ * axis.cosine + across_ * axis.sine;
}

/// Components of a way from the point: from the pole's line, and along it.
Vec2 FrustumWidth::in_half_plane(const SubAxis& axis, const Vec3& way) const {
    return {level(axis).dot(way), pole_.dot(way)};
}

double FrustumWidth::half_tangent_at(const SubAxis& axis, double t) const {
    const double angle = angle_at(axis.place);
    const Vec3 first = view_.on_rim(angle), second = view_.on_to_rim(angle);
    const Vec2 at = in_half_plane(axis, first + (second - first) * t);
    return half_tangent(at.y, std::max(at.x, 0.0));
}

std::vector<ParameterInterval> FrustumWidth::elevations(const SubAxis& axis, double begin,
                                                        double end) const {
    const double a = half_tangent_at(axis, begin), b = half_tangent_at(axis, end);
    const ParameterInterval above = above_horizon(level(axis).dot(normal_), pole_.dot(normal_),
                                                  {std::min(a, b), std::max(a, b)});
    if (!(above.begin < above.end)) return {};
    return {above};
}

double FrustumWidth::lit(const SubAxis& axis, double begin, double end) const {
    double sum = 0;
    for (const ParameterInterval& part : elevations(axis, begin, end))
        sum += arc_integral(level(axis).dot(normal_), pole_.dot(normal_), part);
    return sum;
}

std::vector<double> FrustumWidth::cuts() const {
    constexpr double apart = 1e-6; // of places, below which no line lies between
    std::vector<double> places{-1, 1};
    const auto add = [&](const Vec3& center, double radius) {
        for (const double angle : zeros_of(normal_.dot(center), normal_.dot(view_.nearest) * radius,
                                           normal_.dot(view_.beside) * radius))
            if (const double place = angle / (view_.half * turn_); std::abs(place) < 1 - apart)
                places.push_back(place);
    };
    add(view_.from, view_.radius);
    add(view_.to, view_.to_radius);
    std::sort(places.begin(), places.end());
    const auto near = [](double a, double b) { return b - a < apart; };
    places.erase(std::unique(places.begin(), places.end(), near), places.end());
    return places;
}

/// The generator in the half-plane of a direction.
double FrustumWidth::place_in(const Vec3& way) const {
    const double radius = (view_.radius + view_.to_radius) / 2;
    const Vec3 center = (view_.from + view_.to) / 2, across = pole_.cross(way);
    for (const double angle : zeros_of(across.dot(center), across.dot(view_.nearest) * radius,
                                       across.dot(view_.beside) * radius)) {
        const double place = angle / (view_.half * turn_);
        if (std::abs(place) <= 1 && way.dot(middle(angle)) > 0) return place;
    }
    return std::copysign(2, across_.dot(way));
}

Vec3 FrustumWidth::direction(const SubAxis& axis, double half_tangent) const {
    const double q = 1 / (1 + half_tangent * half_tangent);
    return level(axis) * ((1 - half_tangent * half_tangent) * q) + pole_ * (2 * half_tangent * q);
}

double FrustumWidth::light_rate(const SubAxis& axis, double half_tangent) const {
    const double t = half_tangent, q = 1 / (1 + t * t), cosine = (1 - t * t) * q;
    return direction(axis, t).dot(normal_) * cosine * 2 * q;
}

Vec3 FrustumWidth::place(const SubAxis& axis, double half_tangent) const {
    const double angle = angle_at(axis.place);
    const Vec2 first = in_half_plane(axis, view_.on_rim(angle));
    const Vec2 line = in_half_plane(axis, view_.on_to_rim(angle)) - first;
    const Vec3 way = direction(axis, half_tangent);
    const Vec2 towards = in_half_plane(axis, way);
    return point_ + way * (first.cross(line) / towards.cross(line));
}

} // namespace keiko
