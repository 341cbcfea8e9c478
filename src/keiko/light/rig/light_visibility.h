#pragma once

#include "keiko/geometry/visibility/visibility.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/light/tubes/tube_penumbra.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// From `a` at 0 to `b` at 1, where both see the same number of parts; else nothing.
std::optional<LightVisibility> between(const LightVisibility& a, const LightVisibility& b,
                                       double at);

/// Whether two points see the same parts of a light as a whole, in part and not at all. Between two
/// that do not, its light has a kink.
bool alike(const LightVisibility& a, const LightVisibility& b);

/// Whether a model of a row weighs shadows over the whole width of the lamps: those do that stand
/// for the whole tube. `model`: what is asked for, which a row that names its own overrides.
bool weighs_width(const CPlane& plane, TubeModel model);

/// What a point with a unit normal sees of some lamps of a source, by rising number as
/// lamp_numbers() has them. `visible` answers for that point; a source without extent is asked for
/// as the segment from it to itself. What cannot reach the point is not asked for, and not seen.
/// Without `axes` those of lamps are only asked for where shadows are not weighed over the width,
/// or caps shine.
std::vector<LightVisibility> light_visibilities(const LightSource& source,
                                                std::span<const int> lamps, const Vec3& point,
                                                const Vec3& normal, const Visibility& visible,
                                                TubeModel model, bool axes = true);

} // namespace keiko
