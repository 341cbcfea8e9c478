#include "keiko/render/shading/paint.h"

#include <algorithm>

namespace keiko {
namespace {

Distribution distribution_of(const Roughness& rough) {
    return rough.scratches ? Distribution(rough.kind, rough.width, rough.scratches->across)
                           : Distribution(rough.kind, rough.width);
}

std::optional<Gloss> gloss_of(const Material& material) {
    if (!material.roughness) return {};
    const Roughness& rough = *material.roughness;
    const auto shadowing = rough.mode != GlossMode::brdf                      ? Shadowing::none
                           : rough.kind == DistributionKind::trowbridge_reitz ? Shadowing::smith
                                                                              : Shadowing::cavities;
    return Gloss{distribution_of(rough), rough.mode, shadowing, border_of(material)};
}

std::optional<Flakes> flakes_of(const Material& material) {
    if (!material.flakes || material.metal) return {};
    return Flakes{{DistributionKind::trowbridge_reitz, material.flakes->width},
                  material.flakes->reflectance,
                  material.refractive_index};
}

constexpr double albedo_error = 1e-4; ///< a tenth of the tables' own error of interpolation

std::shared_ptr<const StretchedAlbedo> stretched_albedo_of(const std::optional<Gloss>& gloss) {
    if (!gloss || !gloss->distribution.is_stretched()) return {};
    return std::make_shared<const StretchedAlbedo>(*gloss);
}

template <class Lobe>
std::shared_ptr<const AlbedoTable> table_of(const std::optional<Lobe>& lobe) {
    if (!lobe) return {};
    return std::make_shared<const AlbedoTable>(
        [&](double cosine) { return directional_albedo(*lobe, cosine, albedo_error); });
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

/// Roughness whose widths are multiplied.
Roughness roughened(Roughness rough, double factor) {
    rough.width = integrable_width(rough.kind, rough.width * factor);
    if (rough.scratches)
        rough.scratches->across = integrable_width(rough.kind, rough.scratches->across * factor);
    return rough;
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
      stretched_albedo_(stretched_albedo_of(gloss_)),
      gloss_albedo_(stretched_albedo_ ? stretched_albedo_->mean() : table_of(gloss_)),
      flake_albedo_(table_of(flakes_)),
      mirror_(border_of(material)),
      base_(coat_of(material, gloss_albedo_)),
      takes_light_(gloss_ || flakes_ || base_of(material) != Rgb(0)),
      emitted_(material.emits) {
    if (material.roughness && material.roughness->scratches)
        scratches_ = material.roughness->scratches->direction;
}

Paint Paint::varied(const Material& material, const MapValues& values) const {
    Paint paint = *this;
    if (takes_light_)
        paint.base_ =
            base_.with_base(base_of(material, reflectance(material.diffuse * values.diffuse)));
    paint.emitted_ = material.emits * values.emission;
    paint.gloss_share_ = values.gloss;
    paint.passed_share_ = values.transmission;
    if (gloss_)
        paint.gloss_->distribution =
            distribution_of(roughened(*material.roughness, values.roughness));
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

Rgb Paint::gloss_albedo(double cosine, double doubled) const {
    Rgb sum;
    if (stretched_albedo_)
        sum += gloss_share_ * (*stretched_albedo_)(cosine, doubled);
    else if (gloss_albedo_)
        sum += gloss_share_ * (*gloss_albedo_)(cosine);
    if (flake_albedo_) sum += (*flake_albedo_)(cosine);
    return sum;
}

double Paint::passed_by_brushed(double cosine, double doubled) const {
    if (!stretched_albedo_) return 1;
    const double mean = base_.entering(cosine);
    return mean > 0 ? std::max(0.0, 1 - (*stretched_albedo_)(cosine, doubled).g) / mean : 1;
}

} // namespace keiko
