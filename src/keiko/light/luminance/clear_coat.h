#pragma once

#include "keiko/light/luminance/flake_kernel.h"
#include "keiko/light/luminance/fresnel.h"
#include "keiko/light/luminance/gloss_kernel.h"
#include "keiko/math/rgb.h"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>

namespace keiko {

/// Integral of a kernel over all directions of light above the horizon: the share of uniform light,
/// 0 to 1, that the surface reflects to a viewer under `cosine` above 0. Accurate to about
/// `allowed`. `azimuth`: radians of the viewer from the scratches of a stretched lobe.
Rgb directional_albedo(const Gloss& gloss, double cosine, double allowed = 1e-5,
                       double azimuth = 0);
Rgb directional_albedo(const Flakes& flakes, double cosine, double allowed = 1e-5);

/// Directional albedos tabulated by the cosine, and their mean over the hemisphere.
class AlbedoTable {
public:
    /// Tabulates `albedo` at 65 cosines from 0 to 1, both included, at equal steps of their square
    /// root.
    explicit AlbedoTable(const std::function<Rgb(double cosine)>& albedo);

    /// Albedo interpolated linearly in the square root of the cosine; accurate to about 1e-3. A
    /// cosine outside of 0 to 1 counts as the nearer end.
    Rgb operator()(double cosine) const;
    /// Twice the integral of the table times the cosine over the cosines from 0 to 1.
    const Rgb& mean() const { return mean_; }

private:
    static constexpr std::size_t steps = 64;
    std::array<Rgb, steps + 1> values_; ///< at equal steps of the square root of the cosine
    Rgb mean_;
};

/// Diffuse paint under a clear coat of index `n` >= 1
/// (docs/theory/luminance.md#coats-flakes-metals). Light that enters is refracted, scattered by the
/// base and partly reflected by the coat from within.
class ClearCoat {
public:
    /// Paint under a smooth coat.
    ClearCoat(const Rgb& base_reflectance, double n)
        : ClearCoat(base_reflectance, n, fresnel_mean(n)) {}
    /// Paint under a rough coat that reflects by the table `outside`.
    ClearCoat(const Rgb& base_reflectance, double n, std::shared_ptr<const AlbedoTable> outside)
        : ClearCoat(base_reflectance, n, outside->mean().g) {
        rough_ = std::move(outside);
    }

    /// This coat on another base.
    ClearCoat with_base(const Rgb& base_reflectance) const {
        ClearCoat coat(base_reflectance, n_, mean_);
        coat.rough_ = rough_;
        return coat;
    }

    /// Share of the light that the coat reflects, by the cosine of the angle of incidence.
    double mirrored(double cosine) const {
        if (passes_all()) return 0;
        return rough_ ? (*rough_)(cosine).g : fresnel_dielectric(cosine, n_);
    }
    /// True if it reflects nothing.
    bool passes_all() const { return n_ == 1 && !rough_; }
    /// Share of the light that enters the coat; none where a lobe, as Duer's Ward lobe at grazing
    /// angles, returns more than arrives.
    double entering(double cosine) const { return std::max(0.0, 1 - mirrored(cosine)); }

    /// Reflectance for Lambert's rho E / pi if the illuminance already counts only the share
    /// `entering`, viewed under `cosine_view`.
    Rgb inner_reflectance(double cosine_view) const { return scale_ * entering(cosine_view); }
    /// Reflectance of the base for light that comes in under `cosine_light`, relative to the
    /// arriving light.
    Rgb base_reflectance(double cosine_view, double cosine_light) const {
        return inner_reflectance(cosine_view) * entering(cosine_light);
    }
    /// Reflectance of the base under light that comes uniformly from all sides.
    Rgb base_reflectance_diffuse(double cosine_view) const {
        return inner_reflectance(cosine_view) * (1 - mean_);
    }

private:
    /// Light passes an interface alike in both directions: n^2 (1 - inner) = 1 - mean.
    ClearCoat(const Rgb& base, double n, double mean) : n_(n), mean_(mean) {
        const double n2 = n * n, inner = 1 - (1 - mean) / n2;
        const auto scaled = [&](double rho) { return rho / (n2 * (1 - rho * inner)); };
        scale_ = {scaled(base.r), scaled(base.g), scaled(base.b)};
    }

    double n_, mean_;
    Rgb scale_;
    std::shared_ptr<const AlbedoTable> rough_;
};

} // namespace keiko
