#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/luminance/clear_coat.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/light/rig/light_visibility.h"
#include "keiko/light/tubes/tube_irradiance.h"

#include <span>
#include <vector>

namespace keiko {

/// Illuminance in lx from one source at `point` with unit `normal`, through the medium if there is
/// one. `visible` is the visibility from that point; for a source without extent it is queried with
/// the segment from it to itself. Lamps and beams that cannot reach the point are not queried. A
/// row of lamps that names its own model keeps it. With a `coat` only light that enters it counts.
Rgb illuminance_from(const LightSource& source, const std::optional<Medium>& medium,
                     const Vec3& point, const Vec3& normal, const Visibility& visible,
                     TubeModel model = TubeModel::automatic, const ClearCoat* coat = nullptr);

/// Illuminance from some lamps of a source, each by itself. Their visibility `seen` is that of
/// light_visibilities() with the same `model`; with a coat or a medium it needs axes.
std::vector<Rgb> illuminance_by_lamp(const LightSource& source, std::span<const int> lamps,
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

} // namespace keiko
