#pragma once

#include "keiko/luminance/visible.h"
#include "keiko/rig/light_rig.h"

#include <functional>

namespace keiko {

/// Parts of a segment that an apex sees, parameters 0 to 1: what `Visible` answers, for an apex
/// that is not known beforehand. Empty: nothing stands in the way.
using VisibleFrom = std::function<IntervalSet(const Vec3& apex, const Segment& segment)>;

/// Luminance in cd/m2 at the eye of an eye ray that ends on a surface with luminance `surface`
/// (eq. (1.1) of the physics): the surface through the medium, the medium's ambient light, and
/// the light of each spotlight scattered once in the lit parts of the ray. Lamps on C-planes
/// light surfaces only. Without a medium it is `surface`. A ray that meets nothing ends far away,
/// but not at infinity.
Rgb luminance_along(const LightRig& rig, const Segment& eye_ray, const Rgb& surface,
                    const VisibleFrom& visible_from = {});

} // namespace keiko
