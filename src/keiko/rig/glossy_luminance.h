#pragma once

#include "keiko/luminance/flake_kernel.h"
#include "keiko/luminance/gloss_kernel.h"
#include "keiko/luminance/visible.h"
#include "keiko/rig/light_rig.h"
#include "keiko/tubes/tube_gloss.h"

namespace keiko {

/// Luminance in cd/m2 that the lobe of a kernel sends from `point` to the eye of the kernel, of one
/// source through the medium if there is one: tubes as they are, or the paper's rectangles where a
/// row's `mirror` is flat. `visible` answers for the point. Lamps that hide each other are counted
/// each in full, and tubes outside of the lobe's cone, where it is below 1e-4 of its peak, not at
/// all.
template <class Kernel>
Rgb glossy_luminance_from(const LightSource& source, const std::optional<Medium>& medium,
                          const Vec3& point, const Kernel& kernel, const Visible& visible,
                          GlossQuadrature quadrature = GlossQuadrature::picture);

extern template Rgb glossy_luminance_from(const LightSource&, const std::optional<Medium>&,
                                          const Vec3&, const GlossKernel&, const Visible&,
                                          GlossQuadrature);
extern template Rgb glossy_luminance_from(const LightSource&, const std::optional<Medium>&,
                                          const Vec3&, const FlakeKernel&, const Visible&,
                                          GlossQuadrature);

/// Of all sources of a rig.
template <class Kernel>
Rgb glossy_luminance(const LightRig& rig, const Vec3& point, const Kernel& kernel,
                     const Visible& visible,
                     GlossQuadrature quadrature = GlossQuadrature::picture) {
    Rgb sum;
    for (const LightSource& source : rig.sources)
        sum += glossy_luminance_from(source, rig.medium, point, kernel, visible, quadrature);
    return sum;
}

} // namespace keiko
