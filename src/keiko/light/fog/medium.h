#pragma once

#include "keiko/base/export.h"
#include "keiko/light/fog/height_field.h"
#include "keiko/light/fog/voxel_density.h"
#include "keiko/math/rgb.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <string>
#include <variant>

namespace KEIKO_API keiko {

/// Phase function 1 + k cos^16(gamma / 2), k >= 0, of fog [NishitaShafts]; k = 0 scatters
/// uniformly.
struct HazePhase {
    double k = 0; ///< strength of the forward lobe; 0: uniform

    bool operator==(const HazePhase&) const = default;
};

/// Phase function of [HenyeyGreenstein1941].
struct HenyeyGreenstein {
    double g = 0; ///< mean cosine, above -1 and below 1; positive: forwards

    bool operator==(const HenyeyGreenstein&) const = default;
};

/// Distribution of the light that a medium scatters over the angle gamma of deviation.
using PhaseFunction = std::variant<HazePhase, HenyeyGreenstein>;

/// Phase function in 1/sr, with an integral of 1 over all directions
/// (docs/theory/fog.md#phase-functions). `cosine` is that of gamma: 1 is straight on.
inline double phase(const HazePhase& haze, double cosine) {
    const double cos2 = (1 + cosine) / 2, cos4 = cos2 * cos2, cos8 = cos4 * cos4;
    return (1 + haze.k * cos8 * cos8) / (4 * std::numbers::pi * (1 + haze.k / 9));
}
/// Phase function of Henyey and Greenstein.
inline double phase(const HenyeyGreenstein& lobe, double cosine) {
    const double g = lobe.g, x = 1 + g * g - 2 * g * cosine;
    return (1 - g * g) / (4 * std::numbers::pi * x * std::sqrt(x));
}
/// Phase function of either kind.
inline double phase(const PhaseFunction& function, double cosine) {
    return std::visit([cosine](const auto& kind) { return phase(kind, cosine); }, function);
}

/// Uniform density.
struct HomogeneousDensity {
    bool operator==(const HomogeneousDensity&) const = default;
};

/// Two media, one over the other: dry ice, valley fog. The medium's own extinction lies below.
struct LayeredDensity {
    HeightField border;      ///< the surface between the two
    Rgb extinction_above{0}; ///< 1/m
};

/// The medium's extinction times the density of a grid, whose values are shares.
struct GridDensity {
    std::shared_ptr<const VoxelDensity> grid; ///< never null in a medium
    std::string file{};                       ///< path from which it was read
};

/// Density of a medium over space.
using Density = std::variant<HomogeneousDensity, LayeredDensity, GridDensity>;

/// Quadrature rule of the integral along a camera ray.
enum class ScatteringRule {
    gauss,  ///< in the angle at the lamp, refined to a tolerance; closed form if there is one
    simpson ///< of the papers: uniform along the ray, 16 steps a lit part
};

/// A medium that scatters light once.
struct Medium {
    Rgb extinction{0};     ///< 1/m, absorption and scattering together
    Rgb albedo{0.9};       ///< share of the extinction that is scattering
    Rgb ambient{0};        ///< cd/m2 of an infinite depth of it
    PhaseFunction phase{}; ///< uniform by default
    Density density{};     ///< uniform by default
    /// True if light is attenuated on its way from a lamp to the place of scattering;
    /// [NishitaSpots, eq. 18] omits that indoors.
    bool dims_light_leg = true;
    ScatteringRule rule = ScatteringRule::gauss; ///< that is used
};

} // namespace keiko
