#include "keiko/geometry/bezier/curvature_slope.h"

namespace keiko {
namespace {

/// A tangent vector by du and dv.
struct Components {
    double u, v;

    Components(const SurfaceDerivatives& s, const Vec3& tangent) {
        const double e = s.du().dot(s.du()), f = s.du().dot(s.dv()), g = s.dv().dot(s.dv());
        const double along_u = tangent.dot(s.du()), along_v = tangent.dot(s.dv());
        u = (g * along_u - f * along_v) / (e * g - f * f);
        v = (e * along_v - f * along_u) / (e * g - f * f);
    }
};

double second_form(const SurfaceDerivatives& s, const Vec3& n, const Components& a,
                   const Components& b) {
    return a.u * b.u * s.duu().dot(n) + (a.u * b.v + a.v * b.u) * s.duv().dot(n) +
           a.v * b.v * s.dvv().dot(n);
}

} // namespace

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

} // namespace keiko
