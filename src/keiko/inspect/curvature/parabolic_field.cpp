#include "keiko/inspect/curvature/parabolic_field.h"

#include "keiko/inspect/basics/patch_fields.h"

#include <array>
#include <cmath>

namespace keiko {
namespace {

/// w^4 S_ij . (S_u x S_v) for ij = uu, uv and vv.
std::array<BernsteinField, 3> second_form(const BezierPatchView& patch, double rounding) {
    const HomogeneousField s = homogeneous_field(patch, rounding), u = s.derivative(true),
                           v = s.derivative(false);
    const std::array<HomogeneousField, 3> second{u.derivative(true), u.derivative(false),
                                                 v.derivative(false)};
    const FieldTriple across = cross(u.p, v.p);
    if (!patch.rational())
        return {dot(second[0].p, across), dot(second[1].p, across), dot(second[2].p, across)};
    const FieldTriple normal = normal_field(patch, rounding);
    const BernsteinField volume = dot(s.p, across);
    const auto entry = [&](const HomogeneousField& d) { return dot(d.p, normal) - d.w * volume; };
    return {entry(second[0]), entry(second[1]), entry(second[2])};
}

bool vanishes(const BernsteinField& field) {
    return !(field.magnitude() > field.rounding());
}

int sign_of(const Interval& range) {
    return range.low > 0 ? 1 : range.high < 0 ? -1 : 0;
}

ParabolicField without_sides(BernsteinField field) {
    std::vector<ParabolicSide> sides;
    for (const BoundaryFactor& side : divide_sides(field, 0))
        sides.push_back({side.by_u, side.upper, 0});
    for (ParabolicSide& side : sides) side.sign = sign_of(field.side_range(side.by_u, side.upper));
    return {std::move(field), std::move(sides)};
}

} // namespace

std::optional<ParabolicField> parabolic_field(const BezierPatchView& patch, double rounding) {
    if (patch.degree_u < 2 || patch.degree_v < 2) return std::nullopt; // ruled: nowhere above 0
    const auto [uu, uv, vv] = second_form(patch, rounding);
    BernsteinField numerator = uu * vv - uv * uv;
    if (vanishes(numerator)) return std::nullopt;
    return without_sides(std::move(numerator));
}

// K = (L N - M M) / (E G - F F), so that at K = 0 only the numerator's slopes count. With second
// forms of the normal's length n = |Su x Sv|, K = D / n^4. The other curvature is that of 2 H.
double parabolic_rate(const SurfaceDerivatives& s) {
    const auto d = [&s](std::size_t k, std::size_t l) -> const Vec3& { return s.d[k][l]; };
    const Vec3 normal = s.du().cross(s.dv());
    const Vec3 normal_u = s.duu().cross(s.dv()) + s.du().cross(s.duv());
    const Vec3 normal_v = s.duv().cross(s.dv()) + s.du().cross(s.dvv());
    const double l = s.duu().dot(normal), m = s.duv().dot(normal), n = s.dvv().dot(normal);
    const double by_u = (d(3, 0).dot(normal) + s.duu().dot(normal_u)) * n +
                        l * (d(1, 2).dot(normal) + s.dvv().dot(normal_u)) -
                        2 * m * (d(2, 1).dot(normal) + s.duv().dot(normal_u));
    const double by_v = (d(2, 1).dot(normal) + s.duu().dot(normal_v)) * n +
                        l * (d(0, 3).dot(normal) + s.dvv().dot(normal_v)) -
                        2 * m * (d(1, 2).dot(normal) + s.duv().dot(normal_v));
    const double e = s.du().dot(s.du()), f = s.du().dot(s.dv()), g = s.dv().dot(s.dv());
    const double area2 = normal.dot(normal);
    const double other = std::abs(l * g - 2 * m * f + n * e) / (area2 * std::sqrt(area2));
    const double slope =
        std::sqrt((e * by_v * by_v - 2 * f * by_u * by_v + g * by_u * by_u) / area2) /
        (area2 * area2);
    const double rate = slope / other;
    return std::isfinite(rate) ? rate : 0;
}

} // namespace keiko
