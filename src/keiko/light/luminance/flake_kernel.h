#pragma once

#include "keiko/light/luminance/gloss_kernel.h"

namespace keiko {

/// Metal flakes in a paint below a smooth clear coat. Light is refracted on its way in, reflected
/// by flakes whose normals have the distribution, and refracted on its way out.
struct Flakes {
    /// Distribution of the flakes' normals about that of the surface.
    Distribution distribution{DistributionKind::trowbridge_reitz, 0.3};
    Rgb reflectance{0.3};          ///< share of the light on the flakes that is reflected
    double refractive_index = 1.5; ///< of the coat
};

/// The luminance that flakes reflect to one viewer, in the form of GlossKernel for an interface.
/// The coat's reflection on either way is subtracted
/// (docs/theory/luminance.md#coats-flakes-metals).
class FlakeKernel {
public:
    /// Kernel for a unit normal and the unit direction to the viewer, which is above the surface. A
    /// reference to the flakes is kept.
    FlakeKernel(const Flakes& flakes, const Vec3& normal, const Vec3& eye);

    /// Kernel in 1/sr for the unit direction `light` from the surface, outside of the coat; 0 at
    /// and below the horizon.
    Rgb operator()(const Vec3& light) const;

    /// Unit normal of the surface.
    const Vec3& normal() const { return normal_; }
    /// Unit mirror direction of the viewer's, outside of the coat.
    const Vec3& peak() const { return peak_; }
    /// Spread of the lobe outside of the coat, radians: the distribution's times the coat's
    /// refractive index.
    double spread() const { return flakes_.refractive_index * flakes_.distribution.spread(); }
    /// Chart of the half vectors within the coat, for directions of light outside of it.
    LobeChart chart() const {
        return {peak_, flakes_.distribution.spread(), normal_, inner_eye_,
                flakes_.refractive_index};
    }
    /// Half angle in radians of a cone about peak() for the densities of at least `share` of the
    /// largest: twice that of the light that a viewer along the normal receives. Total reflection
    /// makes it pi. The lobe of a viewer near the horizon may reach beyond the cone.
    double cone(double share) const;

private:
    const Flakes& flakes_;
    Vec3 normal_, inner_eye_, peak_;
    Rgb outside_;
};

} // namespace keiko
