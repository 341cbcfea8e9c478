#pragma once

namespace keiko {

/// Unpolarised reflectance, 0 to 1, of a smooth border between dielectrics. `cosine` >= 0 belongs
/// to the angle of incidence, `n` > 0 is the index behind the border over the one before it; 1
/// where the reflection is total [CookTorrance1982] (docs/theory/luminance.md#fresnel-reflectance).
double fresnel_dielectric(double cosine, double n);

/// Unpolarised reflectance, 0 to 1, of a metal with complex index n + ik seen from air.
double fresnel_conductor(double cosine, double n, double k);

/// Reflectance of a smooth border with relative index `n` > 0 under diffuse light: twice the
/// integral of fresnel_dielectric(c, n) c over c in [0, 1]. From inside a coat of index n it is
/// fresnel_mean(1 / n), which is 1 - (1 - fresnel_mean(n)) / n^2.
double fresnel_mean(double n);

} // namespace keiko
