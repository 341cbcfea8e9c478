#include "keiko/light/sky/sky_light.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

double level_of(const SkyLight& sky) {
    switch (sky.model) {
        case SkyModel::overcast:
            return 1.0 / 3;
        case SkyModel::gradient:
            return sky.horizon;
        default:
            return 1;
    }
}

/// Indicatrix of a clear sky: its rise towards the sun, by the angle to it.
double indicatrix(double angle) {
    const double cosine = std::cos(angle);
    return 0.91 + 10 * std::exp(-3 * angle) + 0.45 * cosine * cosine;
}

/// Gradation of a clear sky: its rise towards the horizon, by the sine of the elevation.
double gradation(double sine) {
    return sine > 0 ? -std::expm1(-0.32 / sine) : 1;
}

} // namespace

SkyDistribution::SkyDistribution(const SkyLight& sky)
    : model_(sky.model),
      level_(level_of(sky)),
      sun_(sky.sun.normalized()),
      scale_(1 / (indicatrix(angle_between(sun_, Vec3(0, 0, 1))) * gradation(1))) {}

double SkyDistribution::operator()(const Vec3& towards) const {
    const double sine = std::max(towards.z, 0.0);
    if (is_linear()) return level() + rise() * sine;
    return indicatrix(angle_between(towards, sun_)) * gradation(sine) * scale_;
}

} // namespace keiko
