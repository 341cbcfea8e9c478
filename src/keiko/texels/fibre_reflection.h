#pragma once

#include "keiko/math/vec.h"

namespace keiko {

/// Sine of the angle between a fibre and the way to a light: the light that a thin cylinder
/// reflects diffusely [KajiyaKay1989]. All directions are unit ones.
double fibre_diffuse(const Vec3& fibre, const Vec3& to_light);

/// Cosine of the angle between the way to the viewer and the cone that a fibre reflects a light
/// into [KajiyaKay1989]. All directions are unit ones.
double fibre_cone_cosine(const Vec3& fibre, const Vec3& to_light, const Vec3& to_viewer);

/// Power of that cosine; 0 for one below 0.
double fibre_specular(double cone_cosine, double exponent);

/// 1/sr: luminance of a fibre, per lx across the light, whose share 1 goes into the highlight of
/// this exponent, at normal incidence.
double fibre_highlight_scale(double exponent);

/// 1/sr: luminance of a fibre that lies across the light, per lx, which reflects all of it
/// diffusely by the sine.
double fibre_diffuse_scale();

} // namespace keiko
