#pragma once

#include "keiko/base/job.h"
#include "keiko/film/film.h"
#include "keiko/raster/mesh_view.h"
#include "keiko/raster/shadow_casters.h"

namespace keiko {

/// lit_pixels() by shadow polygons [Atherton1978]: each triangle that is seen has the shadows of
/// others on it as convex polygons, clipped in space, and pixels are tested against these.
Image lit_by_polygons(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                      const Job& job = {});

} // namespace keiko
