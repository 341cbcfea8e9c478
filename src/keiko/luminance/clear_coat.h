#pragma once

#include "keiko/luminance/fresnel.h"
#include "keiko/math/rgb.h"

namespace keiko {

/// Matt paint under a smooth clear coat of index `n` >= 1 (physics 5.3): light that enters is
/// refracted, scattered by the base and partly thrown back by the coat from within.
class ClearCoat {
public:
    ClearCoat(const Rgb& base_reflectance, double n) : n_(n) {
        const double inner = fresnel_mean(1 / n), n2 = n * n;
        scale_ = {base_reflectance.r / (n2 * (1 - base_reflectance.r * inner)),
                  base_reflectance.g / (n2 * (1 - base_reflectance.g * inner)),
                  base_reflectance.b / (n2 * (1 - base_reflectance.b * inner))};
    }

    /// Share of the light that the coat mirrors, by the cosine of the angle of incidence.
    double mirrored(double cosine) const { return fresnel_dielectric(cosine, n_); }

    /// What takes the place of the reflectance in Lambert's rho E / pi, seen under
    /// `cosine_view` with the light coming in under `cosine_light`.
    Rgb base_reflectance(double cosine_view, double cosine_light) const {
        return scale_ * ((1 - mirrored(cosine_view)) * (1 - mirrored(cosine_light)));
    }
    /// The same under light that comes evenly from all sides.
    Rgb base_reflectance_diffuse(double cosine_view) const {
        return scale_ * ((1 - mirrored(cosine_view)) * (1 - fresnel_mean(n_)));
    }

private:
    double n_;
    Rgb scale_;
};

} // namespace keiko
