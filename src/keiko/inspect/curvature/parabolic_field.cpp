#include "keiko/inspect/curvature/parabolic_field.h"

#include "keiko/inspect/basics/patch_fields.h"

#include <array>

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

} // namespace keiko
