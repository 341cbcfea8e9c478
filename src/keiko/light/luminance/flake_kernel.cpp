#include "keiko/light/luminance/flake_kernel.h"

#include "keiko/light/luminance/fresnel.h"
#include "keiko/math/refract.h"

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// The direction inside a coat of index n > = 1 of light that comes from, or goes to, `outer`.
Vec3 inside(const Vec3& outer, const Vec3& normal, double n) {
    return -*refract(-outer, normal, 1 / n);
}

} // namespace

FlakeKernel::FlakeKernel(const Flakes& flakes, const Vec3& normal, const Vec3& eye)
    : flakes_(flakes),
      normal_(normal),
      inner_eye_(inside(eye, normal, flakes.refractive_index)),
      peak_(reflect(-eye, normal)),
      outside_(flakes.reflectance *
               (1 - fresnel_dielectric(normal.dot(eye), flakes.refractive_index))) {}

Rgb FlakeKernel::operator()(const Vec3& light) const {
    const double nl = normal_.dot(light), n = flakes_.refractive_index;
    if (!(nl > 0)) return {};
    const Vec3 inner = inside(light, normal_, n), sum = inner + inner_eye_;
    const double inner_nl = normal_.dot(inner), length2 = sum.length2();
    const double length = std::sqrt(length2), nh = normal_.dot(sum) / length, vh = length / 2;
    const double density =
        flakes_.distribution.density(nh, normal_.cross(sum).length2() / length2) * nh / (4 * vh);
    // A cone of light narrows at the interface: dw' = dw cos / (n^2 cos').
    const double narrowed = nl / (n * n * inner_nl);
    return outside_ * (density * narrowed * (1 - fresnel_dielectric(nl, n)));
}

double FlakeKernel::cone(double share) const {
    const double inner = flakes_.distribution.cone(share), n = flakes_.refractive_index;
    const double sine = n * std::sin(std::min(inner, std::numbers::pi / 2));
    return sine < 1 ? 2 * std::asin(sine) : std::numbers::pi;
}

} // namespace keiko
