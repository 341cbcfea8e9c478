#pragma once

#include "keiko/light/luminance/distribution.h"
#include "keiko/light/luminance/lobe_chart.h"
#include "keiko/light/luminance/reflectance.h"
#include "keiko/math/vec.h"

namespace keiko {

/// Rule by which a distribution becomes reflected light (docs/theory/luminance.md#lobes).
enum class GlossMode {
    lobe, ///< [NishitaTubes]: a lobe of integral 1, times the reflectance at the angle of view
    brdf  ///< [CookTorrance1982]: D G F / (4 N.V), with what facets shade of each other
};

/// Facets that hide each other: V-shaped cavities [CookTorrance1982], or the correlated heights
/// [Smith1967], [Heitz2014] that belong to Trowbridge and Reitz.
enum class Shadowing { none, cavities, smith };

/// Reflection at a rough border.
struct Gloss {
    Distribution distribution{DistributionKind::beckmann, 0.2};
    GlossMode mode = GlossMode::lobe;
    Shadowing shadowing = Shadowing::none; ///< of mode brdf
    Reflectance reflectance{};
};

/// The light that a rough border sends to one eye, as a function of where it comes from: the
/// luminance is the integral of the kernel times the incoming luminance over directions [1/sr].
class GlossKernel {
public:
    /// Unit normal and unit direction to the eye, which lies above the surface.
    GlossKernel(const Gloss& gloss, const Vec3& normal, const Vec3& eye);

    /// For the unit direction `light` from the surface; 0 below the horizon.
    Rgb operator()(const Vec3& light) const;

    const Vec3& normal() const { return normal_; }
    /// The direction about which the light comes in, and the angle within which most of it does.
    const Vec3& peak() const { return peak_; }
    double spread() const { return gloss_.distribution.spread(); }
    LobeChart chart() const;
    double cone(double share) const { return gloss_.distribution.cone(share); }

private:
    double shaded(double nh, double nl, double vh) const;

    const Gloss& gloss_;
    Vec3 normal_, eye_, peak_;
    double nv_;
    Rgb outside_; ///< the factor that no direction of light changes
};

} // namespace keiko
