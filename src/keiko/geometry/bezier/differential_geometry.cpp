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

/// A tangent vector by du and dv.
struct Components {
    double u, v;

    Components(const SurfaceDerivatives& s, const Vec3& tangent) {
        const FirstForm one = first_form(s);
        const double along_u = tangent.dot(s.du()), along_v = tangent.dot(s.dv());
        u = (one.g * along_u - one.f * along_v) / one.determinant();
        v = (one.e * along_v - one.f * along_u) / one.determinant();
    }
};

double second_form(const SurfaceDerivatives& s, const Vec3& n, const Components& a,
                   const Components& b) {
    return a.u * b.u * s.duu().dot(n) + (a.u * b.v + a.v * b.u) * s.duv().dot(n) +
           a.v * b.v * s.dvv().dot(n);
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

bool has_reliable_curvatures(const SurfaceDerivatives& s, const Vec3& normal) {
    const FirstForm one = first_form(s);
    // The second form has the rounding error of its terms; the first one's least eigenvalue
    // magnifies it.
    const double size = s.du().length() + s.dv().length();
    const double made_of = size + s.duu().length() + 2 * s.duv().length() + s.dvv().length();
    const double least_stretch = one.determinant() / (one.e + one.g);
    const double error = 4 * std::numeric_limits<double>::epsilon() * made_of / least_stretch;
    constexpr double digits = 1e-3;
    if (!(least_stretch > 0)) return false;
    if (error <= digits / size) return true; // nearly everywhere
    const PrincipalCurvatures k = principal_curvatures(s, normal);
    return error <= digits * std::max(std::abs(k.k1), std::abs(k.k2));
}

std::optional<PrincipalCurvatures> reliable_curvatures(const SurfaceDerivatives& s,
                                                       const Vec3& normal) {
    if (!has_reliable_curvatures(s, normal)) return std::nullopt;
    return principal_curvatures(s, normal);
}

SecondForm second_form(const SurfaceDerivatives& s, const Vec3& normal, const Vec3& direction) {
    const Vec3 unit = direction.normalized();
    const Components x(s, unit), y(s, normal.cross(unit));
    return {second_form(s, normal, x, x), second_form(s, normal, x, y),
            second_form(s, normal, y, y)};
}

double normal_curvature(const SurfaceDerivatives& s, const Vec3& normal, const Vec3& direction) {
    const Components along(s, direction);
    const Vec3 tangent = s.du() * along.u + s.dv() * along.v;
    return second_form(s, normal, along, along) / tangent.dot(tangent);
}

double normal_curvature_slope(const SurfaceDerivatives& s, const Vec3& normal,
                              const Vec3& direction) {
    const Components a(s, direction.normalized());
    // The straight line in parameters is curved in space. Its curvature within the tangent plane
    // turns the section along, and is subtracted again.
    const Vec3 second = s.duu() * (a.u * a.u) + s.duv() * (2 * a.u * a.v) + s.dvv() * (a.v * a.v);
    const Vec3 third = s.d[3][0] * (a.u * a.u * a.u) + s.d[2][1] * (3 * a.u * a.u * a.v) +
                       s.d[1][2] * (3 * a.u * a.v * a.v) + s.d[0][3] * (a.v * a.v * a.v);
    const Vec3 sideways = second - normal * second.dot(normal);
    return third.dot(normal) - 3 * second_form(s, normal, a, Components(s, sideways));
}

std::optional<Vec3> robust_normal(SurfaceDerivatives s, const Vec2& uv) {
    constexpr double gone = 1e-8;
    const double mixed = s.duv().length();
    if (s.du().length() < gone * mixed) s.d[1][0] = s.d[2][0] = Vec3(0);
    if (s.dv().length() < gone * mixed) s.d[0][1] = s.d[0][2] = Vec3(0);
    return unit_normal(s, uv);
}

} // namespace keiko
