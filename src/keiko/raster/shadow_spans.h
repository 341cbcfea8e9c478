#pragma once

#include "keiko/base/job.h"
#include "keiko/film/film.h"
#include "keiko/raster/mesh_view.h"
#include "keiko/raster/shadow_casters.h"

namespace keiko {

/// lit_pixels() by scan lines [BouknightKelley1970]: in each row, triangles are projected from the
/// light onto the spans of what is seen, and their edges divide these into lit and dark parts.
Image lit_by_spans(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                   const Job& job = {});

} // namespace keiko
