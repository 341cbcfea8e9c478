#include "keiko/visibility/epipolar/epipolar_curve.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Values of the Bernstein polynomials of degree 5.
std::array<double, 6> basis(double t) {
    const double u = 1 - t, t2 = t * t, u2 = u * u;
    return {u2 * u2 * u,      5 * u2 * u2 * t, 10 * u2 * u * t2,
            10 * u2 * t2 * t, 5 * u * t2 * t2, t2 * t2 * t};
}

} // namespace

EpipolarAxes::EpipolarAxes(const Vec3& at, const Vec3& eye)
    : light(at), z((eye - at).normalized()) {
    const Vec3 least = std::abs(z.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    x = z.cross(least).normalized();
    y = z.cross(x);
}

EpipolarRay::EpipolarRay(const EpipolarAxes& axes, const SegmentPlane& plane) {
    const Vec3 a = axes.local(plane.at(0)), b = axes.local(plane.at(1));
    const double to_a = std::hypot(a.x, a.y), to_b = std::hypot(b.x, b.y);
    off = to_a > to_b ? Vec2(a.x, a.y) / to_a : Vec2(b.x, b.y) / to_b;
    begin = Vec2(to_a, a.z), end = Vec2(to_b, b.z);
    sense = plane.normal().dot(axes.y * off.x - axes.x * off.y) > 0 ? 1 : -1;
}

std::optional<double> EpipolarRay::hidden_by(const Vec2& place) const {
    const double at_begin = begin.x * place.y - begin.y * place.x;
    const double at_end = end.x * place.y - end.y * place.x;
    const double s = at_begin / (at_begin - at_end);
    if (!(s >= 0 && s <= 1)) return std::nullopt;
    const Vec2 hidden = begin + (end - begin) * s;
    return (hidden - place).dot(place) > 0 ? std::optional(s) : std::nullopt;
}

EpipolarCurve::EpipolarCurve(const EpipolarAxes& axes, const BoundaryPiece& line)
    : slack_(line.error), side_(side_of(axes, line)) {
    for (std::size_t i = 0; i < points; ++i) {
        const Vec3 p = axes.local(line.center + line.curve[i]);
        x_[i] = p.x, y_[i] = p.y, z_[i] = p.z;
        slack_ = std::max(slack_, line.error + 1e-14 * p.length());
    }
}

/// Side on which a border is dark, as dark_side returns it, if that is the same all along.
int EpipolarCurve::side_of(const EpipolarAxes& axes, const BoundaryPiece& line) {
    constexpr double useless = 0.2, unsure = 1e-5;
    if (!(line.inward_error < useless)) return 0;
    int side = 0;
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vec3 way = (line.center + line.at(t) - axes.light).normalized();
        const double inward =
            line.inward_at(t).normalized().dot(line.derivative(t).normalized().cross(way));
        if (!(std::abs(inward) > unsure + 2 * line.inward_error)) return 0;
        const int here = inward > 0 ? 1 : -1;
        if (side + here == 0) return 0;
        side = here;
    }
    return side;
}

Vec3 EpipolarCurve::place(double t) const {
    const auto b = basis(t);
    Vec3 at(0);
    for (std::size_t i = 0; i < points; ++i) at += Vec3(x_[i], y_[i], z_[i]) * b[i];
    return at;
}

} // namespace keiko
