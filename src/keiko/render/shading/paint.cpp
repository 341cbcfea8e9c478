#include "keiko/render/shading/paint.h"

namespace keiko {
namespace {

Reflectance border_of(const Material& material) {
    return material.metal ? Reflectance::metal(*material.metal)
                          : Reflectance::dielectric(material.refractive_index);
}

std::optional<Gloss> gloss_of(const Material& material) {
    if (!material.roughness) return {};
    const auto& [kind, width, mode] = *material.roughness;
    const auto shadowing = mode == GlossMode::lobe                      ? Shadowing::none
                           : kind == DistributionKind::trowbridge_reitz ? Shadowing::smith
                                                                        : Shadowing::cavities;
    return Gloss{{kind, width}, mode, shadowing, border_of(material)};
}

std::optional<Flakes> flakes_of(const Material& material) {
    if (!material.flakes || material.metal) return {};
    return Flakes{{DistributionKind::trowbridge_reitz, material.flakes->width},
                  material.flakes->reflectance,
                  material.refractive_index};
}

template <class Lobe>
std::shared_ptr<const AlbedoTable> table_of(const std::optional<Lobe>& lobe) {
    if (!lobe) return {};
    constexpr double allowed = 1e-4; // a tenth of the table's own error of interpolation
    return std::make_shared<const AlbedoTable>(
        [&](double cosine) { return directional_albedo(*lobe, cosine, allowed); });
}

/// Reflectance of the base; flakes take their share of the light first.
Rgb base_of(const Material& material) {
    if (material.metal || material.glass) return {};
    return material.flakes ? material.diffuse * (Rgb(1) - material.flakes->reflectance)
                           : material.diffuse;
}

ClearCoat coat_of(const Material& material, std::shared_ptr<const AlbedoTable> rough) {
    if (material.metal || material.glass) return {Rgb(0), 1};
    if (rough) return {base_of(material), material.refractive_index, std::move(rough)};
    return {base_of(material), material.refractive_index};
}

} // namespace

Paint::Paint(const Material& material)
    : glass_(material.glass),
      refractive_index_(material.refractive_index),
      gloss_(gloss_of(material)),
      flakes_(flakes_of(material)),
      gloss_albedo_(table_of(gloss_)),
      flake_albedo_(table_of(flakes_)),
      mirror_(border_of(material)),
      base_(coat_of(material, gloss_albedo_)),
      takes_light_(gloss_ || flakes_ || base_of(material) != Rgb(0)) {}

Rgb Paint::mirrored(double cosine) const {
    return gloss_ ? Rgb() : mirror_(cosine);
}

Rgb Paint::gloss_albedo(double cosine) const {
    Rgb sum;
    if (gloss_albedo_) sum += (*gloss_albedo_)(cosine);
    if (flake_albedo_) sum += (*flake_albedo_)(cosine);
    return sum;
}

} // namespace keiko
