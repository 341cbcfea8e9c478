#pragma once

#include "keiko/geometry/rays/visibility.h"
#include "keiko/light/penumbra/width_share.h"
#include "keiko/light/rig/prepared_rig.h"
#include "keiko/light/tubes/tube_penumbra.h"

#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// Visibility interpolated from `a` at 0 to `b` at 1, if both see the same number of parts; else
/// nullopt.
std::optional<LightVisibility> between(const LightVisibility& a, const LightVisibility& b,
                                       double at);

/// True if two points see the same parts of a light as a whole, in part and not at all. Between two
/// points that do not, its light has a kink.
bool alike(const LightVisibility& a, const LightVisibility& b);

/// True for a sky that no window bounds.
bool is_open_sky(const PreparedSource& source);

/// True if a model of a row weighs shadows over the whole width of the lamps, as all models of the
/// whole tube do. `model`: the requested one, which a row that names its own overrides.
bool weighs_width(const CPlane& plane, TubeModel model);

/// Accuracy of the visible share of a panel, a sphere or a lobe on one: 3e-3 in pictures, else
/// 5e-5.
WidthOptions area_accuracy(bool in_picture);

/// Visibility of some lamps of a source from a point with a unit normal, by rising number as in
/// lamp_numbers(). `visible` is the visibility from that point; for a source without extent it is
/// queried with the segment from it to itself. Lights that cannot reach the point are not queried,
/// and not visible. Without `axes`, lamps' axes are queried only if shadows are not weighed over
/// the width, or caps shine.
std::vector<LightVisibility> light_visibilities(const PreparedSource& source,
                                                std::span<const int> lamps, const Vec3& point,
                                                const Vec3& normal, const Visibility& visible,
                                                TubeModel model, bool axes = true);

} // namespace keiko
