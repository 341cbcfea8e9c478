#pragma once

#include "keiko/base/job.h"
#include "keiko/film/film.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/raster/mesh_view.h"
#include "keiko/raster/shading_rule.h"
#include "keiko/raster/shadow_casters.h"

#include <cstddef>
#include <vector>

namespace keiko {

/// The share of a light of a rig that a mesh lets reach each pixel.
struct MeshLightShare {
    std::size_t source = 0; ///< into LightRig::sources
    Image share;            ///< one channel, see lit_pixels()
};

/// Shares of the lights of a rig that cast shadows of meshes: lights at points and the sun by an
/// algorithm, panels by it from many points, spheres by cones. Those of other kinds cast
/// none. `casters` as for lit_pixels(). Throws Cancelled.
std::vector<MeshLightShare> mesh_light_shares(const LightRig& rig, const MeshView& view,
                                              const ShadowCasters& casters, MeshShadows by,
                                              const Job& job = {});

} // namespace keiko
