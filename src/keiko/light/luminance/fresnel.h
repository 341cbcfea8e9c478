#pragma once

#include "keiko/base/export.h"
#include "keiko/math/rgb.h"

namespace KEIKO_API keiko {

/// Unpolarised reflectance, 0 to 1, of a smooth interface between dielectrics. `cosine` >= 0
/// belongs to the angle of incidence, `n` > 0 is the index behind the interface over the one before
/// it; 1 if the reflection is total [CookTorrance1982]
/// (docs/theory/luminance.md#fresnel-reflectance).
double fresnel_dielectric(double cosine, double n);

/// Unpolarised reflectance, 0 to 1, of a metal with complex index n + ik in air.
double fresnel_conductor(double cosine, double n, double k);

/// Reflectance of a smooth interface with relative index `n` > 0 under diffuse light: twice the
/// integral of fresnel_dielectric(c, n) c over c in [0, 1]. From inside a coat of index n it is
/// fresnel_mean(1 / n), which is 1 - (1 - fresnel_mean(n)) / n^2.
double fresnel_mean(double n);

/// Index of refraction of a metal, n + ik, for red, green and blue light.
struct MetalIndex {
    Rgb n{1}, k{0}; ///< real and imaginary part, by channel

    bool operator==(const MetalIndex&) const = default;
};

/// Reflectance of a smooth interface, by the cosine of the angle of incidence: 1, that of a
/// dielectric or that of a metal.
class Reflectance {
public:
    /// A mirror without loss.
    Reflectance() = default;
    /// Relative index `n` above 0.
    static Reflectance dielectric(double n) { return {Kind::dielectric, {Rgb(n), Rgb(0)}}; }
    /// A bare metal in air.
    static Reflectance metal(const MetalIndex& index) { return {Kind::metal, index}; }

    /// Reflectance by channel, 0 to 1, for the cosine of the angle of incidence.
    Rgb operator()(double cosine) const {
        if (kind_ == Kind::dielectric) return Rgb(fresnel_dielectric(cosine, index_.n.r));
        if (kind_ == Kind::whole) return Rgb(1);
        const auto& [n, k] = index_;
        return {fresnel_conductor(cosine, n.r, k.r), fresnel_conductor(cosine, n.g, k.g),
                fresnel_conductor(cosine, n.b, k.b)};
    }

private:
    enum class Kind { whole, dielectric, metal };
    Reflectance(Kind kind, const MetalIndex& index) : kind_(kind), index_(index) {}

    Kind kind_ = Kind::whole;
    MetalIndex index_;
};

} // namespace keiko
