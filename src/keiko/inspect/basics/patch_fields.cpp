#include "keiko/inspect/basics/patch_fields.h"

#include <algorithm>

namespace keiko {
namespace {

FieldTriple operator*(const FieldTriple& a, const BernsteinField& b) {
    return {a[0] * b, a[1] * b, a[2] * b};
}

FieldTriple operator+(const FieldTriple& a, const FieldTriple& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}

double magnitude(const FieldTriple& field) {
    return std::max({field[0].magnitude(), field[1].magnitude(), field[2].magnitude()});
}

} // namespace

std::vector<BoundaryFactor> divide_sides(BernsteinField& field, double tolerance) {
    std::vector<BoundaryFactor> sides;
    for (const bool by_u : {true, false})
        for (const bool upper : {false, true}) {
            int times = 0;
            while ((by_u ? field.degree_u() : field.degree_v()) > 0 &&
                   field.side_range(by_u, upper).magnitude() <=
                       std::max(tolerance, 2 * field.rounding())) {
                field = field.without_side(by_u, upper);
                ++times;
            }
            if (times > 0) sides.push_back({by_u, upper, times});
        }
    return sides;
}

FieldTriple cross(const FieldTriple& a, const FieldTriple& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

BernsteinField dot(const FieldTriple& a, const FieldTriple& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

Vec3 value_at(const FieldTriple& field, const Vec2& uv) {
    return {field[0](uv), field[1](uv), field[2](uv)};
}

HomogeneousField HomogeneousField::derivative(bool by_u) const {
    return {{p[0].derivative(by_u), p[1].derivative(by_u), p[2].derivative(by_u)},
            w.derivative(by_u)};
}

HomogeneousField homogeneous_field(const BezierPatchView& patch, double rounding) {
    const auto field = [&](int axis) {
        std::vector<double> values;
        for (const Vec4& point : patch.points) values.push_back(point[static_cast<unsigned>(axis)]);
        return BernsteinField(patch.degree_u, patch.degree_v, std::move(values), rounding);
    };
    return {{field(0), field(1), field(2)}, field(3)};
}

FieldTriple tangent_field(const BezierPatchView& patch, bool by_u, double rounding) {
    const HomogeneousField s = homogeneous_field(patch, rounding), d = s.derivative(by_u);
    if (!patch.rational()) return d.p;
    return d.p * s.w + s.p * (d.w * BernsteinField(0, 0, {-1.0}, 0));
}

FieldTriple normal_field(const BezierPatchView& patch, double rounding) {
    const HomogeneousField s = homogeneous_field(patch, rounding), u = s.derivative(true),
                           v = s.derivative(false);
    FieldTriple across = cross(u.p, v.p);
    if (!patch.rational()) return across;
    return across * s.w + cross(s.p, u.p) * v.w + cross(v.p, s.p) * u.w;
}

FieldTriple without_zero_sides(FieldTriple field) {
    constexpr double nothing = 1e-9;
    const double most = nothing * magnitude(field);
    if (!(most > 0)) return field;
    for (const bool by_u : {true, false})
        for (const bool upper : {false, true}) {
            const auto vanishes = [&](const BernsteinField& f) {
                return f.side_range(by_u, upper).magnitude() <= std::max(most, 2 * f.rounding());
            };
            while ((by_u ? field[0].degree_u() : field[0].degree_v()) > 0 &&
                   std::all_of(field.begin(), field.end(), vanishes))
                for (BernsteinField& f : field) f = f.without_side(by_u, upper);
        }
    return field;
}

} // namespace keiko
