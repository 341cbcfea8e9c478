#pragma once

#include "keiko/raster/mesh_errors.h"
#include "keiko/raster/mesh_view.h"
#include "keiko/raster/mirror_picture.h"

namespace keiko {

/// Compares what a mesh and the exact surface mirror in the same view of a camera.
MeshErrors mesh_errors(const MirrorPicture& truth, const MirrorPicture& mesh, const Camera& camera);

/// Facet borders of a mesh under a lamp at the eye, as viewports have it: luminance is the cosine
/// between the normal and the way to the eye. Borders count where three pixels in a row show one
/// face in both. Throws Cancelled.
FacetBands facet_bands(const MeshView& view, const MirrorPicture& truth, const MirrorPicture& mesh,
                       const Job& job = {});

} // namespace keiko
