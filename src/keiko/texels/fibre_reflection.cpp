#include "keiko/texels/fibre_reflection.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

double fibre_diffuse(const Vec3& fibre, const Vec3& to_light) {
    return fibre.cross(to_light).length();
}

double fibre_cone_cosine(const Vec3& fibre, const Vec3& to_light, const Vec3& to_viewer) {
    return fibre_diffuse(fibre, to_light) * fibre_diffuse(fibre, to_viewer) -
           fibre.dot(to_light) * fibre.dot(to_viewer);
}

double fibre_specular(double cone_cosine, double exponent) {
    return std::pow(std::max(0.0, cone_cosine), exponent);
}

double fibre_highlight_scale(double exponent) {
    // A length of the width w sends c w cos(a) cos^p(a) at the angle a to its normal plane, whose
    // integral over all directions must be the w E that it takes.
    const double integral = std::sqrt(std::numbers::pi) * std::exp(std::lgamma((exponent + 3) / 2) -
                                                                   std::lgamma((exponent + 4) / 2));
    return 1 / (2 * std::numbers::pi * integral);
}

double fibre_diffuse_scale() {
    return 1 / (std::numbers::pi * std::numbers::pi);
}

} // namespace keiko
