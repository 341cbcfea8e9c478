#pragma once

#include "keiko/base/job.h"
#include "keiko/film/film.h"
#include "keiko/math/vec.h"
#include "keiko/raster/mesh_view.h"
#include "keiko/raster/shadow_casters.h"

namespace keiko {

/// A sphere that emits uniformly, as a light of meshes.
struct LightSphere {
    Vec3 center{0};    ///< world, mm
    double radius = 0; ///< mm, above 0
};

/// Share of the illuminance by a sphere that reaches each pixel, as lit_pixels() of many points, by
/// the cone from the place to the sphere [Amanatides1984]. What triangles hide of it before the
/// circle in which the cone touches the sphere is found on `chords` lines across the sphere's
/// image, and exact along these. 0 for places within the sphere. Throws Cancelled.
Image lit_by_cones(const MeshView& view, const ShadowCasters& casters, const LightSphere& sphere,
                   const Job& job = {}, int chords = 16);

} // namespace keiko
