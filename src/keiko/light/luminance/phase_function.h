#pragma once

#include <cmath>
#include <numbers>
#include <variant>

namespace keiko {

/// Phase function 1 + k cos^16(gamma / 2), k >= 0, of fog [NishitaShafts]; k = 0 scatters evenly.
struct HazePhase {
    double k = 0;

    bool operator==(const HazePhase&) const = default;
};

/// Phase function of [HenyeyGreenstein1941].
struct HenyeyGreenstein {
    double g = 0; ///< mean cosine, above -1 and below 1; positive: forwards

    bool operator==(const HenyeyGreenstein&) const = default;
};

/// How a medium spreads the light that it scatters over the angle gamma of deviation.
using PhaseFunction = std::variant<HazePhase, HenyeyGreenstein>;

/// Phase function in 1/sr, with an integral of 1 over all directions
/// (docs/theory/fog.md#phase-functions). `cosine` is that of gamma: 1 is straight on.
inline double phase(const HazePhase& haze, double cosine) {
    const double cos2 = (1 + cosine) / 2, cos4 = cos2 * cos2, cos8 = cos4 * cos4;
    return (1 + haze.k * cos8 * cos8) / (4 * std::numbers::pi * (1 + haze.k / 9));
}
inline double phase(const HenyeyGreenstein& lobe, double cosine) {
    const double g = lobe.g, x = 1 + g * g - 2 * g * cosine;
    return (1 - g * g) / (4 * std::numbers::pi * x * std::sqrt(x));
}
inline double phase(const PhaseFunction& function, double cosine) {
    return std::visit([cosine](const auto& kind) { return phase(kind, cosine); }, function);
}

} // namespace keiko
