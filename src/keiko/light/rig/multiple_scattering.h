#pragma once

#include "keiko/light/rig/light_rig.h"

namespace keiko {

/// How often light is scattered on average on its way from a lamp that shines into the medium, by
/// way of `place` to the eye: the optical depth of both legs, all mm, times the albedo; the largest
/// of all lamps and channels. Of a sun behind windows the eye's leg alone counts. 0 where no light
/// is scattered. Pictures hold light that is scattered once, so that this should be well below 1.
double scatterings_by_way_of(const LightRig& rig, const Vec3& place, const Vec3& eye);

} // namespace keiko
