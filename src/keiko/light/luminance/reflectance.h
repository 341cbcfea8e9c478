#pragma once

#include "keiko/light/luminance/fresnel.h"
#include "keiko/math/rgb.h"

namespace keiko {

/// Index of refraction of a metal, n + ik, for red, green and blue light.
struct MetalIndex {
    Rgb n{1}, k{0};

    bool operator==(const MetalIndex&) const = default;
};

/// What share of the light a smooth border mirrors, by the cosine of the angle of incidence: all
/// of it, that of a dielectric or that of a metal.
class Reflectance {
public:
    /// A mirror without loss.
    Reflectance() = default;
    /// Relative index `n` above 0.
    static Reflectance dielectric(double n) { return {Kind::dielectric, {Rgb(n), Rgb(0)}}; }
    static Reflectance metal(const MetalIndex& index) { return {Kind::metal, index}; }

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
