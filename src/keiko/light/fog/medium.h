#pragma once

#include "keiko/light/fog/height_field.h"
#include "keiko/light/fog/voxel_density.h"
#include "keiko/light/luminance/phase_function.h"
#include "keiko/math/rgb.h"

#include <memory>
#include <string>
#include <variant>

namespace keiko {

/// The same everywhere.
struct HomogeneousDensity {
    bool operator==(const HomogeneousDensity&) const = default;
};

/// Two media, one over the other: dry ice, valley fog. The medium's own extinction lies below.
struct LayeredDensity {
    HeightField border;
    Rgb extinction_above{0}; ///< 1/m
};

/// The medium's extinction times the density of a grid, whose values are shares.
struct GridDensity {
    std::shared_ptr<const VoxelDensity> grid;
    std::string file{}; ///< where it was read from
};

using Density = std::variant<HomogeneousDensity, LayeredDensity, GridDensity>;

/// What the integral along a camera ray is taken by.
enum class ScatteringRule {
    gauss,  ///< in the angle at the lamp, refined to a tolerance; closed form where there is one
    simpson ///< of the papers: evenly along the ray, 16 steps a lit part
};

/// A medium that scatters light once.
struct Medium {
    Rgb extinction{0};     ///< 1/m, absorption and scattering together
    Rgb albedo{0.9};       ///< share of the extinction that is scattering
    Rgb ambient{0};        ///< cd/m2 that an infinite depth of it shows
    PhaseFunction phase{}; ///< even, unless told
    Density density{};
    /// Whether light is dimmed on its way from a lamp to where it is scattered; [NishitaSpots, eq.
    /// 18] leaves that out indoors.
    bool dims_light_leg = true;
    ScatteringRule rule = ScatteringRule::gauss;
};

} // namespace keiko
