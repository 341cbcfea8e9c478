#pragma once

#include "keiko/patch/surface_model.h"
#include "keiko/trace/hit.h"

namespace keiko {

/// The ray that a mirror surface makes of an eye ray at its hit: from the hit along the mirror
/// direction, its own root excluded. With differentials, exact from the second derivatives of the
/// patch, where the eye ray has them and the patch is regular there.
Ray mirrored_ray(const SurfaceModel& model, const Hit& hit, const Ray& eye_ray);

/// The hit's unit normal on the side the ray comes from.
Vec3 facing_normal(const Hit& hit, const Ray& ray);

/// S and its derivatives to order 2 at the hit, in world coordinates.
SurfaceDerivatives world_derivatives(const SurfaceModel& model, const Hit& hit);

} // namespace keiko
