#include "keiko/maps/bump.h"

namespace keiko {

SurfaceDerivatives raised(const SurfaceDerivatives& surface, const Vec3& normal,
                          const HeightJet& height) {
    const auto& d = surface.d;
    const auto second = [&](const Vec3& a, const Vec3& b, const Vec3& ab) {
        return normal * (height.along(a, b) + height.gradient.dot(ab));
    };
    SurfaceDerivatives sum = surface;
    sum.d[1][0] += normal * height.gradient.dot(d[1][0]);
    sum.d[0][1] += normal * height.gradient.dot(d[0][1]);
    sum.d[2][0] += second(d[1][0], d[1][0], d[2][0]);
    sum.d[1][1] += second(d[1][0], d[0][1], d[1][1]);
    sum.d[0][2] += second(d[0][1], d[0][1], d[0][2]);
    return sum;
}

Vec3 raised_normal(const Vec3& normal, const Vec3& gradient) {
    return (normal - square_to(gradient, normal)).normalized();
}

Vec3 mapped_normal(const Rgb& texel, const Vec3& tangent, const Vec3& bitangent,
                   const Vec3& normal) {
    return (tangent * texel.r + bitangent * texel.g + normal * texel.b).normalized();
}

} // namespace keiko
