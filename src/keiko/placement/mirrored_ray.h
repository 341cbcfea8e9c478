#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/intersect/hit/hit.h"

namespace keiko {

/// reflect_ray for hits of any tracer: second derivatives that the hit lacks are taken from the
/// model.
Ray mirrored_ray(const SurfaceModel& model, const Hit& hit, const Ray& camera_ray);

/// The hit's unit normal on the side the ray comes from.
Vec3 facing_normal(const Hit& hit, const Ray& ray);

/// S and its derivatives to order 2 at the hit, in world coordinates.
SurfaceDerivatives world_derivatives(const SurfaceModel& model, const Hit& hit);

} // namespace keiko
