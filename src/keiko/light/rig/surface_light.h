#pragma once

#include "keiko/geometry/rays/visibility.h"
#include "keiko/light/luminance/clear_coat.h"
#include "keiko/light/luminance/flake_kernel.h"
#include "keiko/light/luminance/gloss_kernel.h"
#include "keiko/light/rig/light_visibility.h"
#include "keiko/light/tubes/tube_gloss.h"
#include "keiko/light/tubes/tube_irradiance.h"

#include <span>
#include <vector>

namespace keiko {

// Light from the sources of a rig at a point of a surface: its illuminance, and the luminance that
// a lobe reflects.

/// Illuminance in lx from one source at `point` with unit `normal`, through the medium if there is
/// one. `visible` is the visibility from that point; for a source without extent it is queried with
/// the segment from it to itself. Lamps and beams that cannot reach the point are not queried. A
/// row of lamps that names its own model keeps it. With a `coat` only light that enters it counts.
Rgb illuminance_from(const PreparedSource& source, const std::optional<Medium>& medium,
                     const Vec3& point, const Vec3& normal, const Visibility& visible,
                     TubeModel model = TubeModel::automatic, const ClearCoat* coat = nullptr);

/// Illuminance from some lamps of a source, each by itself. Their visibility `seen` is that of
/// light_visibilities() with the same `model`; with a coat or a medium it needs axes.
std::vector<Rgb> illuminance_by_lamp(const PreparedSource& source, std::span<const int> lamps,
                                     std::span<const LightVisibility> seen,
                                     const std::optional<Medium>& medium, const Vec3& point,
                                     const Vec3& normal, TubeModel model,
                                     const ClearCoat* coat = nullptr);

/// Illuminance in lx from every source of a rig, in its order.
std::vector<Rgb> illuminance_by_source(const LightRig& rig, const Vec3& point, const Vec3& normal,
                                       const Visibility& visible,
                                       TubeModel model = TubeModel::automatic);

/// Sum over all sources of a rig, without its ambient light.
Rgb direct_illuminance(const LightRig& rig, const Vec3& point, const Vec3& normal,
                       const Visibility& visible, TubeModel model = TubeModel::automatic,
                       const ClearCoat* coat = nullptr);

/// Luminance in cd/m2 that the lobe of a kernel reflects from `point` to the kernel's viewer, of
/// one source, through the medium if there is one. Lamps are exact tubes, or the paper's rectangles
/// if a row's `mirror` is flat. `visible` is the visibility from the point. Lamps that hide each
/// other are each counted in full. Tubes, panels and spheres outside of the lobe's cone, where it
/// is below 1e-4 of its peak, do not count.
template <class Kernel>
Rgb glossy_luminance_from(const PreparedSource& source, const std::optional<Medium>& medium,
                          const Vec3& point, const Kernel& kernel, const Visibility& visible,
                          GlossQuadrature quadrature = GlossQuadrature::picture);

/// Luminance of some lamps of a source, each by itself. `seen` is their visibility with axes, as
/// returned by light_visibilities(). Of a panel or a sphere that is partly `seen`, `visible` is
/// queried for the share that counts for the lobe.
template <class Kernel>
std::vector<Rgb> glossy_luminance_by_lamp(const PreparedSource& source, std::span<const int> lamps,
                                          std::span<const LightVisibility> seen,
                                          const std::optional<Medium>& medium, const Vec3& point,
                                          const Kernel& kernel, const Visibility& visible,
                                          GlossQuadrature quadrature = GlossQuadrature::picture);

extern template Rgb glossy_luminance_from(const PreparedSource&, const std::optional<Medium>&,
                                          const Vec3&, const GlossKernel&, const Visibility&,
                                          GlossQuadrature);
extern template Rgb glossy_luminance_from(const PreparedSource&, const std::optional<Medium>&,
                                          const Vec3&, const FlakeKernel&, const Visibility&,
                                          GlossQuadrature);
extern template std::vector<Rgb> glossy_luminance_by_lamp(const PreparedSource&,
                                                          std::span<const int>,
                                                          std::span<const LightVisibility>,
                                                          const std::optional<Medium>&, const Vec3&,
                                                          const GlossKernel&, const Visibility&,
                                                          GlossQuadrature);
extern template std::vector<Rgb> glossy_luminance_by_lamp(const PreparedSource&,
                                                          std::span<const int>,
                                                          std::span<const LightVisibility>,
                                                          const std::optional<Medium>&, const Vec3&,
                                                          const FlakeKernel&, const Visibility&,
                                                          GlossQuadrature);

/// Luminance in cd/m2 that the lobe of a kernel reflects to its viewer, of all sources of a rig.
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
