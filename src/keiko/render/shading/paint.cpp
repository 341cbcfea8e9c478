#include "keiko/render/shading/paint.h"

#include <algorithm>

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
Rgb base_of(const Material& material, const Rgb& diffuse) {
    if (material.metal || material.glass) return {};
    return material.flakes ? diffuse * (Rgb(1) - material.flakes->reflectance) : diffuse;
}
Rgb base_of(const Material& material) {
    return base_of(material, material.diffuse);
}

/// A reflectance, whatever a map made of it.
Rgb reflectance(const Rgb& color) {
    const auto share = [](double x) { return std::clamp(x, 0.0, 1.0); };
    return {share(color.r), share(color.g), share(color.b)};
}

/// Width of a lobe that kernels can integrate, by what scenes may state.
double integrable_width(DistributionKind kind, double width) {
    const bool exponent = kind == DistributionKind::phong || kind == DistributionKind::blinn;
    return exponent ? std::clamp(width, 1.0, 1e6) : std::clamp(width, 0.005, 1.0);
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
      takes_light_(gloss_ || flakes_ || base_of(material) != Rgb(0)),
      emitted_(material.emits) {}

Paint Paint::varied(const Material& material, const MapValues& values) const {
    Paint paint = *this;
    if (takes_light_)
        paint.base_ =
            base_.with_base(base_of(material, reflectance(material.diffuse * values.diffuse)));
    paint.emitted_ = material.emits * values.emission;
    paint.gloss_share_ = values.gloss;
    paint.passed_share_ = values.transmission;
    if (gloss_) {
        const auto& [kind, width, mode] = *material.roughness;
        paint.gloss_->distribution = {kind, integrable_width(kind, width * values.roughness)};
    }
    return paint;
}

Rgb Paint::mirrored(double cosine) const {
    return gloss_ ? Rgb() : mirror_(cosine);
}

double Paint::lobe_width() const {
    double spread = 0;
    if (gloss_) spread = gloss_->distribution.spread();
    if (flakes_) spread = std::max(spread, flakes_->distribution.spread());
    constexpr double widest = 2; // beyond, a square of directions stands for nothing
    return std::min(2 * spread, widest);
}

Rgb Paint::gloss_albedo(double cosine) const {
    Rgb sum;
    if (gloss_albedo_) sum += gloss_share_ * (*gloss_albedo_)(cosine);
    if (flake_albedo_) sum += (*flake_albedo_)(cosine);
    return sum;
}

} // namespace keiko
