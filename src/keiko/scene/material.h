#pragma once

#include "keiko/base/export.h"
#include "keiko/light/luminance/gloss_kernel.h"
#include "keiko/math/rgb.h"
#include "keiko/scene/material_map.h"
#include "keiko/scene/scratches.h"
#include "keiko/scene/texel_spec.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// A rough border, which shows lamps blurred and nothing else.
struct Roughness {
    DistributionKind kind = DistributionKind::beckmann; ///< distribution of the facets
    double width = 0.2;               ///< the distribution's own parameter, above 0
    GlossMode mode = GlossMode::lobe; ///< rule that makes light of the distribution
    /// Scratches of a brushed surface, with Beckmann's or Trowbridge and Reitz's facets; none: it
    /// is as rough in all directions.
    std::optional<Scratches> scratches{};

    bool operator==(const Roughness&) const = default;
};

/// Metal flakes in the base, which show lamps widely blurred.
struct FlakeLayer {
    Rgb reflectance{0.3}; ///< share of the light that entered, 0 to 1; the base has the rest
    double width = 0.3;   ///< of their Trowbridge-Reitz distribution

    bool operator==(const FlakeLayer&) const = default;
};

/// Clear glass or plastic, which passes what it does not mirror.
struct Glass {
    Rgb absorption{0}; ///< 1/mm along the way of light inside, by channel, 0 or more
    /// mm, above 0: the face stands for a pane so thick, which light crosses straight on; 0: it
    /// bounds a solid body, which bends light
    double pane = 0;

    bool operator==(const Glass&) const = default;
};

/// A Lambertian base under a clear coat, a bare metal, or glass.
struct Material {
    std::string name;                     ///< by which scenes name it
    Rgb diffuse{0.03};                    ///< reflectance of the base, 0 to 1; of paints alone
    double refractive_index = 1.5;        ///< of the coat or the glass; 1: no coat, no mirror
    std::optional<MetalIndex> metal{};    ///< instead of base and coat
    std::optional<Glass> glass{};         ///< instead of base and coat; smooth, without flakes
    std::optional<Roughness> roughness{}; ///< of the coat or the metal; none: a smooth mirror
    std::optional<FlakeLayer> flakes{};   ///< none by default
    std::vector<MaterialMap> maps{};      ///< that vary it over a surface
    std::optional<TexelSpec> texels{};    ///< fibres over it; none by default
    Rgb emits{0}; ///< cd/m2, alike in all directions, beside what it reflects
    /// True if faces light others from both sides, else from the outer one. A luminance that maps
    /// vary is visible on these sides.
    bool emits_both_ways = false;

    bool operator==(const Material&) const = default;
};

/// True if a material emits light of a luminance that a map varies.
inline bool has_emission_map(const Material& material) {
    return std::any_of(material.maps.begin(), material.maps.end(), [](const MaterialMap& map) {
        return map.drives == MappedQuantity::emission;
    });
}

/// Moves the maps and the scratches of a material with its model.
inline void place_material(const Affine& motion, Material& material) {
    for (MaterialMap& map : material.maps) map.placement = motion * map.placement;
    if (material.roughness && material.roughness->scratches) {
        ScratchDirection& direction = material.roughness->scratches->direction;
        direction = moved(motion, direction);
    }
}

/// True for each of some faces whose material casts no shadow: glass, and what emits light, as
/// lamps hide nothing.
inline std::vector<bool> shadowless_faces(std::span<const Material> materials) {
    std::vector<bool> faces;
    for (const Material& material : materials)
        faces.push_back(material.glass.has_value() || material.emits != Rgb(0));
    return faces;
}

/// Reflectance of a material's border.
inline Reflectance border_of(const Material& material) {
    return material.metal ? Reflectance::metal(*material.metal)
                          : Reflectance::dielectric(material.refractive_index);
}

} // namespace keiko
