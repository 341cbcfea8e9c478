#pragma once

#include <numbers>

namespace keiko {

/// Phase function of fog, 1/sr: (1 + k cos^16(gamma / 2)) / (4 pi (1 + k / 9)), whose integral
/// over all directions is 1 ([002], normalised; physics 8.3). `cosine` belongs to the angle
/// gamma by which light is deviated: 1 is straight on. k >= 0; k = 0 scatters evenly.
constexpr double fog_phase(double cosine, double k) {
    const double cos2 = (1 + cosine) / 2, cos4 = cos2 * cos2, cos8 = cos4 * cos4;
    return (1 + k * cos8 * cos8) / (4 * std::numbers::pi * (1 + k / 9));
}

} // namespace keiko
