#include "keiko/placement/feature_direction.h"

#include <cmath>

namespace keiko {
namespace {

/// The tangent of least absolute normal curvature, and by how much it bends less.
struct LeastBend {
    Vec3 tangent{0};
    double difference = 0;
};

LeastBend least_bend(const SurfaceDerivatives& s, const Vec3& normal) {
    const PrincipalCurvatures k = principal_curvatures(s, normal);
    const bool second = std::abs(k.k2) < std::abs(k.k1);
    const double least = second ? k.k2 : k.k1, most = second ? k.k1 : k.k2;
    // (II - least I) (a, b) = 0 has two rows; the longer one tells (a, b) better.
    const Vec3 du = s.du(), dv = s.dv();
    const Vec2 first_row(normal.dot(s.duu()) - least * du.length2(),
                         normal.dot(s.duv()) - least * du.dot(dv));
    const Vec2 second_row(first_row.y, normal.dot(s.dvv()) - least * dv.length2());
    const Vec2 row = first_row.length2() > second_row.length2() ? first_row : second_row;
    const Vec3 tangent = du * -row.y + dv * row.x;
    if (!(tangent.length() > 0)) return {};
    return {tangent.normalized(), std::abs(most) - std::abs(least)};
}

} // namespace

FeatureDirection feature_direction(const SurfaceDerivatives& surface, const Ray& mirrored) {
    const Vec3 across = surface.du().cross(surface.dv());
    const double spread = surface.du().length() * surface.dv().length();
    if (!mirrored.differentials || !(across.length() > 1e-9 * spread)) return {};
    const LeastBend bend = least_bend(surface, across.normalized());
    const Vec3& x = mirrored.differentials->origin_dx;
    const Vec3& y = mirrored.differentials->origin_dy;
    // The step in the picture whose place on the surface moves along the tangent.
    const double xx = x.length2(), xy = x.dot(y), yy = y.length2();
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 0) || !(bend.difference > 0)) return {};
    const double tx = x.dot(bend.tangent), ty = y.dot(bend.tangent);
    const Vec2 step((yy * tx - xy * ty) / determinant, (xx * ty - xy * tx) / determinant);
    if (!(step.length() > 0) || !std::isfinite(step.length())) return {};
    return {step.normalized(), bend.difference};
}

} // namespace keiko
