#include "keiko/trace/pencil_line.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Of the Bernstein polynomials of degree 5.
std::array<double, 6> basis(double t) {
    const double u = 1 - t, t2 = t * t, u2 = u * u;
    return {u2 * u2 * u,      5 * u2 * u2 * t, 10 * u2 * u * t2,
            10 * u2 * t2 * t, 5 * u * t2 * t2, t2 * t2 * t};
}

} // namespace

PencilAxes::PencilAxes(const Vec3& at, const Vec3& eye) : light(at), z((eye - at).normalized()) {
    const Vec3 least = std::abs(z.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    x = z.cross(least).normalized();
    y = z.cross(x);
}

PencilRay::PencilRay(const PencilAxes& axes, const SegmentPlane& plane) {
    const Vec3 a = axes.local(plane.at(0)), b = axes.local(plane.at(1));
    const double to_a = std::hypot(a.x, a.y), to_b = std::hypot(b.x, b.y);
    off = to_a > to_b ? Vec2(a.x, a.y) / to_a : Vec2(b.x, b.y) / to_b;
    begin = Vec2(to_a, a.z), end = Vec2(to_b, b.z);
    sense = plane.normal().dot(axes.y * off.x - axes.x * off.y) > 0 ? 1 : -1;
}

std::optional<double> PencilRay::hidden_by(const Vec2& place) const {
    const double at_begin = begin.x * place.y - begin.y * place.x;
    const double at_end = end.x * place.y - end.y * place.x;
    const double s = at_begin / (at_begin - at_end);
    if (!(s >= 0 && s <= 1)) return std::nullopt;
    const Vec2 hidden = begin + (end - begin) * s;
    return (hidden - place).dot(place) > 0 ? std::optional(s) : std::nullopt;
}

PencilLine::PencilLine(const PencilAxes& axes, const BorderPiece& line)
    : slack_(line.error), side_(side_of(axes, line)) {
    for (std::size_t i = 0; i < points; ++i) {
        const Vec3 p = axes.local(line.center + line.curve[i]);
        x_[i] = p.x, y_[i] = p.y, z_[i] = p.z;
        slack_ = std::max(slack_, line.error + 1e-14 * p.length());
    }
}

/// As dark_side of a border tells, if that is the same all along.
int PencilLine::side_of(const PencilAxes& axes, const BorderPiece& line) {
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

/// By Newton's method kept inside, in powers of t.
double PencilLine::single_root(const Values& c) {
    static_assert(points == 6);
    Values power = c;
    for (std::size_t level = 1; level < points; ++level)
        for (std::size_t i = points - 1; i >= level; --i) power[i] -= power[i - 1];
    power[1] *= 5, power[2] *= 10, power[3] *= 10, power[4] *= 5;
    double a = 0, b = 1, t = c.front() / (c.front() - c.back());
    constexpr int most_steps = 60;
    constexpr double settled = 1e-4; // the next step is about its square
    for (int i = 0; i < most_steps; ++i) {
        double value = power[5], slope = 0;
        for (std::size_t k = points - 1; k-- > 0;) {
            slope = slope * t + value;
            value = value * t + power[k];
        }
        ((value < 0) == (c.front() < 0) ? a : b) = t;
        const double next = t - value / slope;
        const bool close = std::abs(next - t) <= settled;
        t = next >= a && next <= b ? next : (a + b) / 2;
        if (close || b - a <= settled * settled) break;
    }
    return t;
}

int PencilLine::direction(const Values& c, double t) {
    Values b = c;
    for (std::size_t last = points - 1; last > 1; --last)
        for (std::size_t i = 0; i < last; ++i) b[i] += (b[i + 1] - b[i]) * t;
    return b[1] > b[0] ? 1 : b[1] < b[0] ? -1 : 0;
}

Vec3 PencilLine::place(double t) const {
    const auto b = basis(t);
    Vec3 at(0);
    for (std::size_t i = 0; i < points; ++i) at += Vec3(x_[i], y_[i], z_[i]) * b[i];
    return at;
}

} // namespace keiko
