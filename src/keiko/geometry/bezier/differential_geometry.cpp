#include "keiko/geometry/bezier/differential_geometry.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Unit cross product; nullopt if its length is small against its factors, where its direction is
/// undefined.
std::optional<Vec3> unit_cross(const Vec3& a, const Vec3& b, double scale) {
    const Vec3 n = a.cross(b);
    const double length = n.length();
    constexpr double relative_zero = 1e-12;
    if (!(length > relative_zero * scale)) return std::nullopt;
    return n / length;
}

struct FirstForm {
    double e, f, g;
    double determinant() const { return e * g - f * f; }
};

FirstForm first_form(const SurfaceDerivatives& s) {
    return {s.du().dot(s.du()), s.du().dot(s.dv()), s.dv().dot(s.dv())};
}

} // namespace

std::optional<Vec3> unit_normal(const SurfaceDerivatives& s, const Vec2& uv) {
    const double size_u = s.du().length() + s.duu().length();
    const double size_v = s.dv().length() + s.dvv().length();
    const double scale = std::max(size_u * size_v, 1e-300);
    if (auto n = unit_cross(s.du(), s.dv(), scale)) return n;

    // Move an infinitesimal step into the patch: du(v + h) = du + h duv, dv(u + h) = dv + h duv.
    const double to_inside_u = uv.x < 0.5 ? 1 : -1, to_inside_v = uv.y < 0.5 ? 1 : -1;
    const double mixed = s.duv().length();
    if (auto n = unit_cross(s.duv() * to_inside_v, s.dv(), mixed * size_v)) return n;
    return unit_cross(s.du(), s.duv() * to_inside_u, mixed * size_u);
}

PrincipalCurvatures principal_curvatures(const SurfaceDerivatives& s, const Vec3& normal) {
    // The second form in an orthonormal frame: a symmetric matrix, whose eigenvalues keep their
    // digits where they are equal, unlike the roots of k^2 - 2 H k + K.
    const FirstForm one = first_form(s);
    const double l = s.duu().dot(normal), m = s.duv().dot(normal), n = s.dvv().dot(normal);
    const double skew = one.f / one.e, width2 = one.determinant() / one.e;
    const double h11 = l / one.e, h12 = (m - skew * l) / std::sqrt(one.determinant());
    const double h22 = (n - 2 * skew * m + skew * skew * l) / width2;
    const double mean = (h11 + h22) / 2, spread = std::hypot((h11 - h22) / 2, h12);
    return {mean + spread, mean - spread};
}

std::optional<PrincipalCurvatures> reliable_curvatures(const SurfaceDerivatives& s,
                                                       const Vec3& normal) {
    const FirstForm one = first_form(s);
    // The second form has the rounding error of its terms; the first one's least eigenvalue
    // magnifies it.
    const double size = s.du().length() + s.dv().length();
    const double made_of = size + s.duu().length() + 2 * s.duv().length() + s.dvv().length();
    const double least_stretch = one.determinant() / (one.e + one.g);
    const double error = 4 * std::numeric_limits<double>::epsilon() * made_of / least_stretch;
    const PrincipalCurvatures k = principal_curvatures(s, normal);
    constexpr double digits = 1e-3;
    const double bend = std::max({std::abs(k.k1), std::abs(k.k2), 1 / size});
    return least_stretch > 0 && error <= digits * bend ? std::optional(k) : std::nullopt;
}

double normal_curvature(const SurfaceDerivatives& s, const Vec3& normal, const Vec3& direction) {
    const FirstForm one = first_form(s);
    const double du = direction.dot(s.du()), dv = direction.dot(s.dv());
    const double a = (one.g * du - one.f * dv) / one.determinant();
    const double b = (one.e * dv - one.f * du) / one.determinant();
    const double second =
        a * a * s.duu().dot(normal) + 2 * a * b * s.duv().dot(normal) + b * b * s.dvv().dot(normal);
    const Vec3 tangent = s.du() * a + s.dv() * b;
    return second / tangent.dot(tangent);
}

} // namespace keiko
