#include "keiko/inspect/curvature/parabolic_field.h"

#include "keiko/inspect/basics/boundary_factors.h"

#include <array>

namespace keiko {
namespace {

using Triad = std::array<BernsteinField, 3>;

BernsteinField dot(const Triad& a, const Triad& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Triad cross(const Triad& a, const Triad& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Triad operator*(const Triad& a, const BernsteinField& b) {
    return {a[0] * b, a[1] * b, a[2] * b};
}

Triad operator+(const Triad& a, const Triad& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

/// A homogeneous point, or a derivative of one.
struct Homogeneous {
    Triad p;
    BernsteinField w;

    Homogeneous derivative(bool by_u) const {
        return {{p[0].derivative(by_u), p[1].derivative(by_u), p[2].derivative(by_u)},
                w.derivative(by_u)};
    }
};

Homogeneous homogeneous(const BezierPatchView& patch, double rounding) {
    const auto field = [&](int axis) {
        std::vector<double> values;
        for (const Vec4& point : patch.points) values.push_back(point[static_cast<unsigned>(axis)]);
        return BernsteinField(patch.degree_u, patch.degree_v, std::move(values), rounding);
    };
    return {{field(0), field(1), field(2)}, field(3)};
}

/// w^4 S_ij . (S_u x S_v) for ij = uu, uv and vv.
std::array<BernsteinField, 3> second_form(const BezierPatchView& patch, double rounding) {
    const Homogeneous s = homogeneous(patch, rounding), u = s.derivative(true),
                      v = s.derivative(false);
    const std::array<Homogeneous, 3> second{u.derivative(true), u.derivative(false),
                                            v.derivative(false)};
    const Triad across = cross(u.p, v.p);
    if (!patch.rational())
        return {dot(second[0].p, across), dot(second[1].p, across), dot(second[2].p, across)};
    const Triad normal = across * s.w + cross(s.p, u.p) * v.w + cross(v.p, s.p) * u.w;
    const BernsteinField volume = dot(s.p, across);
    const auto entry = [&](const Homogeneous& d) { return dot(d.p, normal) - d.w * volume; };
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
