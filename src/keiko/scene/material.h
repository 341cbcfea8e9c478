#pragma once

#include "keiko/base/export.h"
#include "keiko/light/luminance/gloss_kernel.h"
#include "keiko/math/rgb.h"

#include <optional>
#include <string>

namespace KEIKO_API keiko {

/// A rough border, which shows lamps blurred and nothing else.
struct Roughness {
    DistributionKind kind = DistributionKind::beckmann; ///< distribution of the facets
    double width = 0.2;               ///< the distribution's own parameter, above 0
    GlossMode mode = GlossMode::lobe; ///< rule that makes light of the distribution

    bool operator==(const Roughness&) const = default;
};

/// Metal flakes in the base, which show lamps widely blurred.
struct FlakeLayer {
    Rgb reflectance{0.3}; ///< share of the light that entered, 0 to 1; the base has the rest
    double width = 0.3;   ///< of their Trowbridge-Reitz distribution

    bool operator==(const FlakeLayer&) const = default;
};

/// A Lambertian base under a clear coat, or a bare metal.
struct Material {
    std::string name;                     ///< by which scenes name it
    Rgb diffuse{0.03};                    ///< reflectance of the base, 0 to 1; unused by metals
    double refractive_index = 1.5;        ///< of the coat; 1: no coat, no mirror
    std::optional<MetalIndex> metal{};    ///< instead of base and coat
    std::optional<Roughness> roughness{}; ///< of the coat or the metal; none: a smooth mirror
    std::optional<FlakeLayer> flakes{};   ///< none by default

    bool operator==(const Material&) const = default;
};

} // namespace keiko
