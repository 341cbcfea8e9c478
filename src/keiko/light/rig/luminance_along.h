#pragma once

#include "keiko/geometry/rays/visibility.h"
#include "keiko/light/fog/single_scattering.h"
#include "keiko/light/rig/light_rig.h"

#include <functional>

namespace keiko {

/// Parts of a segment that are visible from a source of the rig, given by its index; parameters 0
/// to 1. Empty function: nothing is occluded.
using VisibleFrom = std::function<IntervalSet(std::size_t source, const Segment& segment)>;

/// Parts of a camera ray that a source lights in the medium, without occlusion: in the beam of a
/// spotlight, luminaire or point, or behind the windows of a sun. Empty if it lights no medium.
IntervalSet in_light(const LightSource& source, const Segment& camera_ray);

/// Luminance in cd/m2 of a camera ray that ends on a surface with luminance `surface`
/// (docs/theory/fog.md#the-sum-along-a-camera-ray). It is the sum of the surface through the
/// medium, the medium's ambient light, and the light of each source scattered once in the lit parts
/// of the ray, to a relative error of `tolerance`. Lamps on C-planes, and a sun without windows,
/// light surfaces only. Without a medium it is `surface`. A ray that misses the scene ends far
/// away, but not at infinity.
Rgb luminance_along(const LightRig& rig, const Segment& camera_ray, const Rgb& surface,
                    const VisibleFrom& visible_from = {}, double tolerance = scattering_tolerance);

/// Mean number of scatterings of light on its way from a lamp that shines into the medium, by way
/// of `place` to the camera. It is the optical depth of both legs, all mm, times the albedo; the
/// largest of all lamps and channels. For a sun behind windows the camera's leg alone counts. It is
/// 0 if no light is scattered. Pictures hold singly scattered light, so this should be well below
/// 1.
double scatterings_by_way_of(const LightRig& rig, const Vec3& place, const Vec3& eye);

} // namespace keiko
