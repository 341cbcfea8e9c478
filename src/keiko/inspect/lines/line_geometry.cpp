#include "keiko/inspect/lines/line_geometry.h"

#include "keiko/base/units.h"
#include "keiko/inspect/basics/placed_face.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

template <class T>
using Second = Jet<Jet<T>>;

/// Derivatives of the surface, d[k][l], k + l <= 3, as numbers or intervals.
template <class T>
using Entries = std::array<std::array<Triple<T>, 4>, 4>;

Entries<double> plain(const SurfaceDerivatives& surface) {
    Entries<double> d;
    for (std::size_t k = 0; k < 4; ++k)
        for (std::size_t l = 0; k + l < 4; ++l) {
            const Vec3& from = surface.d[k][l];
            d[k][l] = {from.x, from.y, from.z};
        }
    return d;
}

/// d[k][l] as a function of the patch parameters, with its own first or second derivatives.
template <class T>
Triple<Jet<T>> first_jet(const Entries<T>& d, std::size_t k, std::size_t l) {
    const auto one = [&](T Triple<T>::*x) {
        return Jet<T>(d[k][l].*x, d[k + 1][l].*x, d[k][l + 1].*x);
    };
    return {one(&Triple<T>::x), one(&Triple<T>::y), one(&Triple<T>::z)};
}

template <class T>
Triple<Second<T>> second_jet(const Entries<T>& d, std::size_t k, std::size_t l) {
    const auto f = first_jet(d, k, l), u = first_jet(d, k + 1, l), v = first_jet(d, k, l + 1);
    return {{f.x, u.x, v.x}, {f.y, u.y, v.y}, {f.z, u.z, v.z}};
}

/// Field and first fundamental form in the notation of docs/theory/reflection-lines.md: f the
/// field, E, F, G of the first fundamental form, rho the squared length of the gradient.
template <class T>
struct Course {
    Triple<T> run; ///< along the line, for a normal along du x dv
    T value, speed, rho, bend, rho_along, rho_across;
};

template <class T>
Course<T> course(const LineField& field, double level, const Entries<T>& d, double side) {
    using std::sqrt;
    const Triple<Second<T>> normal = cross(second_jet(d, 1, 0), second_jet(d, 0, 1));
    const auto ratio = field.ratio(second_jet(d, 0, 0), normal * Second<T>(side), level);
    const Second<T> f = ratio.above / ratio.below;
    const Triple<Jet<T>> su = first_jet(d, 1, 0), sv = first_jet(d, 0, 1);
    const Jet<T> uu = length2(su), uv = dot(su, sv), vv = length2(sv), area2 = uu * vv - uv * uv;
    const Jet<T> rho = (uu * square(f.v) - uv * f.u * f.v * Jet<T>(2.0) + vv * square(f.u)) / area2;
    const T du = f.v.f, dv = -f.u.f;
    const T ddu = f.v.u * du + f.v.v * dv, ddv = -(f.u.u * du + f.u.v * dv);
    const Triple<T> run = d[1][0] * du + d[0][1] * dv;
    const Triple<T> turn = d[2][0] * square(du) + d[1][1] * (T(2.0) * du * dv) +
                           d[0][2] * square(dv) + d[1][0] * ddu + d[0][1] * ddv;
    const T speed = sqrt(length2(run)), area = sqrt(area2.f);
    const T rise_u = (vv.f * f.u.f - uv.f * f.v.f) / area2.f;
    const T rise_v = (uu.f * f.v.f - uv.f * f.u.f) / area2.f;
    return {run,
            f.f.f,
            speed,
            rho.f,
            dot(cross(d[1][0], d[0][1]), cross(run, turn)) / (area * speed * square(speed)),
            (rho.u * du + rho.v * dv) / speed,
            (rho.u * rise_u + rho.v * rise_v) / sqrt(rho.f)};
}

/// -1 if du x dv points away from the viewpoint, else 1.
double side_of(const LineField& field, const SurfaceDerivatives& surface) {
    const Vec3 normal = surface.du().cross(surface.dv());
    return field.eye().towards(surface.position()).dot(normal) > 0 ? -1 : 1;
}

double half_width(const Interval& a) {
    return (a.high - a.low) / 2;
}

Interval widened(double x, double by) {
    return {x - by, x + by};
}

/// The derivatives widened by rounding and by their change within `off` mm of the place.
Entries<Interval> widened(const SurfaceDerivatives& surface, int degree, double off) {
    const double reach =
        surface.position().length() + surface.du().length() + surface.dv().length();
    const double du = off / surface.du().length(), dv = off / surface.dv().length();
    const auto size = [&](std::size_t k, std::size_t l) {
        if (k + l < 4) return surface.d[k][l].length();
        const double third = std::max({surface.d[3][0].length(), surface.d[2][1].length(),
                                       surface.d[1][2].length(), surface.d[0][3].length()});
        return 2.0 * degree * degree * third;
    };
    Entries<Interval> d;
    double rounding = 8 * std::numeric_limits<double>::epsilon() * reach;
    for (std::size_t order = 0; order < 4; ++order, rounding *= 2 * degree)
        for (std::size_t k = 0; k <= order; ++k) {
            const std::size_t l = order - k;
            const double by = rounding + size(k + 1, l) * du + size(k, l + 1) * dv;
            const Vec3& from = surface.d[k][l];
            d[k][l] = {widened(from.x, by), widened(from.y, by), widened(from.z, by)};
        }
    return d;
}

/// Degrees. A stretch that turns by less is visually straight, and often straight to within
/// rounding.
constexpr double least_turning = 0.05;

/// A stretch of a line with curvature of one sign.
struct Stretch {
    std::size_t begin = 0; ///< the course that it begins with
    double turning = 0;    ///< degrees
};

std::vector<Stretch> stretches(std::span<const CourseAt> courses) {
    std::vector<Stretch> found;
    for (std::size_t i = 1; i < courses.size(); ++i) {
        const double bend = (courses[i - 1].course.bend + courses[i].course.bend) / 2;
        const double turning = radians_to_degrees(bend * courses[i].step);
        if (!found.empty() && (found.back().turning < 0) == (turning < 0))
            found.back().turning += turning;
        else
            found.push_back({i - 1, turning});
    }
    return found;
}

/// The course at or before the change of sign with which a stretch begins.
std::size_t change_before(std::span<const CourseAt> courses, const Stretch& stretch) {
    const double bend = courses[stretch.begin].course.bend;
    return bend * stretch.turning > 0 && stretch.begin > 0 ? stretch.begin - 1 : stretch.begin;
}

std::vector<std::size_t> inflections(std::span<const CourseAt> courses,
                                     const std::vector<Stretch>& stretches) {
    std::vector<std::size_t> found;
    double before = 0;
    for (const Stretch& stretch : stretches) {
        if (std::abs(stretch.turning) < least_turning) continue;
        if (before * stretch.turning < 0) found.push_back(change_before(courses, stretch));
        before = stretch.turning;
    }
    return found;
}

void take_spacing(LineStatistics& shape, const LineGeometry& course, double step) {
    const double spacing = step / course.density;
    if (!std::isfinite(spacing)) return;
    shape.least_spacing =
        shape.least_spacing > 0 ? std::min(shape.least_spacing, spacing) : spacing;
    shape.most_spacing = std::max(shape.most_spacing, spacing);
    shape.spacing_ratio =
        std::max(shape.spacing_ratio, 1 + std::abs(spacing * course.spread_across));
    shape.spacing_rate = std::max(shape.spacing_rate, std::abs(course.spread_along));
}

/// A place of the line and its curvature there.
struct Bent {
    LinePoint at;
    double bend = 0;
};

/// The place of the line next to parameters of the patch, by steps across it.
std::optional<Bent> on_line(const SurfaceModel& model, const SurfaceLine& piece,
                            const LampLevels& lamps, Vec2 uv) {
    constexpr int most_steps = 10;
    constexpr double close = 1e-10; // mm
    for (int i = 0; i < most_steps; ++i) {
        const SurfaceDerivatives s = placed_derivatives(model, piece.instance, piece.patch, uv);
        const auto course = line_course(lamps.field, lamps.level(piece.lamp), s);
        if (!course) return std::nullopt;
        const double off = -course->value / course->density;
        if (std::abs(off) < close || i + 1 == most_steps)
            return Bent{{uv, s.position()}, course->bend};
        const Vec3 step = course->left() * off;
        const double uu = s.du().length2(), mixed = s.du().dot(s.dv()), vv = s.dv().length2();
        const double along_u = s.du().dot(step), along_v = s.dv().dot(step);
        const double area = uu * vv - mixed * mixed;
        uv += Vec2(along_u * vv - along_v * mixed, along_v * uu - along_u * mixed) / area;
    }
    return std::nullopt;
}

} // namespace

std::optional<LineGeometry> line_course(const LineField& field, double level,
                                        const SurfaceDerivatives& surface) {
    const double side = side_of(field, surface);
    const Vec3 normal = surface.du().cross(surface.dv());
    const Course<double> c = course(field, level, plain(surface), side);
    if (!(normal.length() > 0 && c.speed > 0 && std::isfinite(c.value) && std::isfinite(c.rho)))
        return std::nullopt;
    LineGeometry result;
    result.normal = normal.normalized() * side;
    result.tangent = Vec3(c.run.x, c.run.y, c.run.z) * (side / c.speed);
    result.bend = c.bend;
    result.value = c.value;
    result.density = std::sqrt(c.rho);
    result.spread_along = -c.rho_along * side / (2 * c.rho);
    result.spread_across = -c.rho_across / (2 * c.rho);
    return result;
}

LineGeometryBounds line_course_bounds(const LineField& field, double level,
                                      const SurfaceDerivatives& surface, int degree, double off) {
    const Course<Interval> c =
        course(field, level, widened(surface, degree, off), side_of(field, surface));
    const Vec3 loose(half_width(c.run.x), half_width(c.run.y), half_width(c.run.z));
    constexpr double infinity = std::numeric_limits<double>::infinity();
    const double direction = c.speed.low > 0 ? loose.length() / c.speed.low : infinity;
    const auto known = [](double x) { return std::isfinite(x) ? x : infinity; };
    return {known(direction), known(half_width(c.bend)), known(half_width(c.value))};
}

LineStatistics line_shape(std::span<const CourseAt> courses, double step) {
    LineStatistics shape;
    double turning = 0;
    const std::vector<Stretch> parts = stretches(courses);
    for (const Stretch& part : parts)
        shape.turning += part.turning, turning += std::abs(part.turning);
    shape.waviness = turning - std::abs(shape.turning);
    shape.inflections = inflections(courses, parts);
    for (const CourseAt& at : courses) {
        shape.length += at.step;
        if (std::abs(at.course.bend) > std::abs(shape.largest_bend))
            shape.largest_bend = at.course.bend;
        if (step > 0) take_spacing(shape, at.course, step);
    }
    return shape;
}

LineInflection inflection_between(const SurfaceModel& model, const SurfaceLine& piece,
                                  const LampLevels& lamps, const LinePoint& before,
                                  const LinePoint& behind) {
    auto near = on_line(model, piece, lamps, before.uv),
         far = on_line(model, piece, lamps, behind.uv);
    LinePoint found = before;
    constexpr int halvings = 45;
    for (int i = 0; near && far && i < halvings; ++i) {
        const auto middle = on_line(model, piece, lamps, (near->at.uv + far->at.uv) / 2);
        if (!middle) break;
        found = middle->at;
        (middle->bend * near->bend > 0 ? near : far) = middle;
    }
    return {(found.place - before.place).length(), found.place};
}

} // namespace keiko
