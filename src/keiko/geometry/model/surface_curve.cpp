#include "keiko/geometry/model/surface_curve.h"

#include "keiko/base/job.h"
#include "keiko/geometry/bezier/differential_geometry.h"
#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// A patch parameter and its derivatives by t, from those of the face parameter.
struct Chained {
    double value, first, second;
};

Chained through(const ParameterMap& map, double face, double face_first, double face_second) {
    const double x = map.to_patch(face);
    const double slope = map.derivative(x), bend = map.second_derivative(x);
    const double first = face_first / slope;
    return {x, first, (face_second - bend * first * first) / slope};
}

void transform_vectors(const Affine& transform, SurfaceDerivatives& s, std::size_t order) {
    for (std::size_t k = 0; k <= order; ++k)
        for (std::size_t l = 0; k + l <= order; ++l) s.d[k][l] = transform.vector(s.d[k][l]);
    s.d[0][0] += transform.translation;
}

} // namespace

struct SurfaceCurve::Place {
    std::uint32_t patch;
    Chained u, v;
    SurfaceDerivatives surface;
};

SurfaceCurve::Place SurfaceCurve::place(double t, int order) const {
    const std::array<Vec2, 4> p = evaluate(p_curve_, t, 2);
    const Vec2 toward = Vec2(-p[1].y, p[1].x) * side_;
    const std::uint32_t index = grid_->locate(p[0], toward);
    const Patch& patch = model_->patches[index];
    Place result{index,
                 through(patch.map_u, p[0].x, p[1].x, p[2].x),
                 through(patch.map_v, p[0].y, p[1].y, p[2].y),
                 {}};
    result.surface = evaluate(model_->patch(index), Vec2(result.u.value, result.v.value), order);
    transform_vectors(*transform_, result.surface, static_cast<std::size_t>(order));
    return result;
}

std::uint32_t SurfaceCurve::patch_at(double t) const {
    const std::array<Vec2, 4> p = evaluate(p_curve_, t, 1);
    return grid_->locate(p[0], Vec2(-p[1].y, p[1].x) * side_);
}

int SurfaceCurve::degree_at(double t) const {
    const BezierPatchView patch = model_->patch(patch_at(t));
    return std::max(patch.degree_u, patch.degree_v);
}

namespace {

/// Adds the parameters at which the patch changes between two parameters on different patches, in
/// rising order. Halves until only neighbouring numbers are left, so patches in between are found
/// too.
void add_changes(const SurfaceCurve& curve, double low, std::uint32_t at_low, double high,
                 std::uint32_t at_high, std::vector<double>& changes) {
    if (at_low == at_high) return;
    const double middle = (low + high) / 2;
    constexpr double fine = 1e-14;
    if (!(high - low > fine)) {
        changes.push_back(middle);
        return;
    }
    const std::uint32_t between = curve.patch_at(middle);
    add_changes(curve, low, at_low, middle, between, changes);
    add_changes(curve, middle, between, high, at_high, changes);
}

} // namespace

std::vector<double> SurfaceCurve::patch_changes(double begin, double end) const {
    std::vector<double> changes;
    const int patches = patch_count();
    if (patches < 2) return changes;
    const int steps = 2 * patches + 2;
    double before = begin;
    std::uint32_t patch_before = patch_at(before);
    for (int i = 1; i <= steps; ++i) {
        const double t = begin + (end - begin) * i / steps;
        const std::uint32_t patch = patch_at(t);
        add_changes(*this, before, patch_before, t, patch, changes);
        before = t, patch_before = patch;
    }
    return changes;
}

SurfaceCurve::Point SurfaceCurve::at(double t) const {
    const Place p = place(t, 2);
    const SurfaceDerivatives& s = p.surface;
    return {s.position(), s.du() * p.u.first + s.dv() * p.v.first,
            s.duu() * (p.u.first * p.u.first) + s.duv() * (2 * p.u.first * p.v.first) +
                s.dvv() * (p.v.first * p.v.first) + s.du() * p.u.second + s.dv() * p.v.second};
}

std::optional<BoundaryFrame> SurfaceCurve::frame(double t, int order) const {
    const Place p = place(t, order);
    const Vec3 first = p.surface.du() * p.u.first + p.surface.dv() * p.v.first;
    const double speed = first.length();
    // Near a pole du x dv is mostly rounding: its direction is accurate to 1e-8 rad.
    constexpr double regular = 1e-8;
    const double area = p.surface.du().cross(p.surface.dv()).length();
    if (!(speed > 0 && area > regular * grid_->square_size(p.patch))) return std::nullopt;
    const auto normal = unit_normal(p.surface, Vec2(p.u.value, p.v.value));
    if (!normal) return std::nullopt;
    const Vec3 tangent = first / speed;
    // Turning left in the parameter plane is turning about du x dv in space.
    const Vec3 inward = normal->cross(tangent) * side_;
    return BoundaryFrame{p.surface.position(), tangent, *normal, inward, p.surface};
}

double SurfaceCurve::speed(double t) const {
    const Place p = place(t, 1);
    return (p.surface.du() * p.u.first + p.surface.dv() * p.v.first).length();
}

double SurfaceCurve::length(double begin, double end) const {
    const auto [low, high] = std::minmax(begin, end);
    return length(low, high, patch_changes(low, high));
}

double SurfaceCurve::length(double begin, double end, std::span<const double> changes) const {
    constexpr int panels = 4; // a smooth piece
    constexpr double relative = 1e-10;
    constexpr int most_halvings = 24; // unequal weights crowd the length into a short range
    const auto speed_at = [this](double t) {
        check_stop();
        return speed(t);
    };
    const auto rounding = [this](double t) { // all of a pole's length
        const Place p = place(t, 0);
        return 1e-12 * (p.surface.position().length() + std::sqrt(grid_->square_size(p.patch)));
    };
    double sum = 0, from = begin;
    const auto add_until = [&](double until) {
        for (int i = 0; i < panels; ++i) {
            const double a = from + (until - from) * i / panels;
            const double b = from + (until - from) * (i + 1) / panels;
            const double allowed = rounding(a) + relative * integrate(speed_at, a, b, 8);
            sum += integrate_adaptively(speed_at, a, b, allowed, most_halvings);
        }
        from = until;
    };
    for (const double change : changes) add_until(change);
    add_until(end);
    return sum;
}

} // namespace keiko
