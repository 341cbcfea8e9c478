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
/// one. `visible` answers for that point; a source without extent is asked for as the segment
/// from it to itself. Lamps and beams that cannot reach the point are not asked for at all. A row
/// of lamps that names its own model keeps it. With a `coat` only what enters it counts.
Rgb illuminance_from(const LightSource& source, const std::optional<Medium>& medium,
                     const Vec3& point, const Vec3& normal, const Visibility& visible,
                     TubeModel model = TubeModel::automatic, const ClearCoat* coat = nullptr);

/// The same from some lamps of a source, each by itself, of which `seen` is known, as
/// light_visibilities() has it with the same `model`; with a coat or a medium with axes.
std::vector<Rgb> illuminance_by_lamp(const LightSource& source, std::span<const int> lamps,
                                     std::span<const LightVisibility> seen,
                                     const std::optional<Medium>& medium, const Vec3& point,
                                     const Vec3& normal, TubeModel model,
                                     const ClearCoat* coat = nullptr);

/// Illuminance in lx from every source of a rig, in its order.
std::vector<Rgb> illuminance_by_source(const LightRig& rig, const Vec3& point, const Vec3& normal,
                                       const Visibility& visible,
                                       TubeModel model = TubeModel::automatic);

/// Their sum, without the rig's ambient light.
Rgb direct_illuminance(const LightRig& rig, const Vec3& point, const Vec3& normal,
                       const Visibility& visible, TubeModel model = TubeModel::automatic,
                       const ClearCoat* coat = nullptr);

} // namespace keiko
