#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/luminance/flake_kernel.h"
#include "keiko/light/luminance/gloss_kernel.h"
#include "keiko/light/rig/light_visibility.h"
#include "keiko/light/tubes/tube_gloss.h"

#include <span>
#include <vector>

namespace keiko {

/// Luminance in cd/m2 that the lobe of a kernel sends from `point` to the eye of the kernel, of one
/// source through the medium if there is one: tubes as they are, or the paper's rectangles where a
/// row's `mirror` is flat. `visible` answers for the point. Lamps that hide each other are counted
/// each in full, and tubes outside of the lobe's cone, where it is below 1e-4 of its peak, not at
/// all.
template <class Kernel>
Rgb glossy_luminance_from(const LightSource& source, const std::optional<Medium>& medium,
                          const Vec3& point, const Kernel& kernel, const Visibility& visible,
                          GlossQuadrature quadrature = GlossQuadrature::picture);

/// The same from some lamps of a source, each by itself, of whose axes `seen` is known, as
/// light_visibilities() has it.
template <class Kernel>
std::vector<Rgb> glossy_luminance_by_lamp(const LightSource& source, std::span<const int> lamps,
                                          std::span<const LightVisibility> seen,
                                          const std::optional<Medium>& medium, const Vec3& point,
                                          const Kernel& kernel,
                                          GlossQuadrature quadrature = GlossQuadrature::picture);

extern template Rgb glossy_luminance_from(const LightSource&, const std::optional<Medium>&,
                                          const Vec3&, const GlossKernel&, const Visibility&,
                                          GlossQuadrature);
extern template Rgb glossy_luminance_from(const LightSource&, const std::optional<Medium>&,
                                          const Vec3&, const FlakeKernel&, const Visibility&,
                                          GlossQuadrature);
extern template std::vector<Rgb> glossy_luminance_by_lamp(const LightSource&, std::span<const int>,
                                                          std::span<const LightVisibility>,
                                                          const std::optional<Medium>&, const Vec3&,
                                                          const GlossKernel&, GlossQuadrature);
extern template std::vector<Rgb> glossy_luminance_by_lamp(const LightSource&, std::span<const int>,
                                                          std::span<const LightVisibility>,
                                                          const std::optional<Medium>&, const Vec3&,
                                                          const FlakeKernel&, GlossQuadrature);

/// Luminance in cd/m2 that the lobe of a kernel sends to its eye, of all sources of a rig.
template <class Kernel>
Rgb glossy_luminance(const LightRig& rig, const Vec3& point, const Kernel& kernel,
                     const Visibility& visible,
                     GlossQuadrature quadrature = GlossQuadrature::picture) {
    Rgb sum;
    for (const LightSource& source : rig.sources)
        sum += glossy_luminance_from(source, rig.medium, point, kernel, visible, quadrature);
    return sum;
}

} // namespace keiko
