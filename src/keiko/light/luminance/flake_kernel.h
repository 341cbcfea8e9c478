#pragma once

#include "keiko/light/luminance/gloss_kernel.h"

namespace keiko {

/// Metal flakes in a paint below a smooth clear coat. Light is refracted on its way in, reflected
/// by flakes whose normals have the distribution, and refracted on its way out.
struct Flakes {
    Distribution distribution{DistributionKind::trowbridge_reitz, 0.3};
    Rgb reflectance{0.3};          ///< share of the light on the flakes that is reflected
    double refractive_index = 1.5; ///< of the coat
};

/// The luminance that flakes reflect to one viewer, in the form of GlossKernel for an interface.
/// The coat's reflection on either way is subtracted
/// (docs/theory/luminance.md#coats-flakes-metals).
class FlakeKernel {
public:
    FlakeKernel(const Flakes& flakes, const Vec3& normal, const Vec3& eye);

    Rgb operator()(const Vec3& light) const;

    const Vec3& normal() const { return normal_; }
    const Vec3& peak() const { return peak_; }
    double spread() const { return flakes_.refractive_index * flakes_.distribution.spread(); }
    LobeChart chart() const {
        return {peak_, flakes_.distribution.spread(), normal_, inner_eye_,
                flakes_.refractive_index};
    }
    double cone(double share) const;

private:
    const Flakes& flakes_;
    Vec3 normal_, inner_eye_, peak_;
    Rgb outside_;
};

} // namespace keiko
