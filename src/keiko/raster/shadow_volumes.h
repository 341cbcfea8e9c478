#pragma once

#include "keiko/base/job.h"
#include "keiko/film/film.h"
#include "keiko/raster/mesh_view.h"
#include "keiko/raster/shadow_casters.h"

namespace keiko {

/// lit_pixels() by shadow volumes [Crow1977]: behind the contour of what the light meets stand the
/// sides of the shadowed space. Those before the place in a pixel are counted, where the line of
/// sight enters it and where it leaves it.
Image lit_by_volumes(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                     const Job& job = {});

} // namespace keiko
