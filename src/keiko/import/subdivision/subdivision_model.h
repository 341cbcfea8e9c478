#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/model/surface_model.h"

#include <filesystem>

namespace keiko {

/// Reads an OBJ file as the cage of a subdivision surface (subdivision::read_cage tells what it may
/// hold) and returns its limit surface: Catmull-Clark [CatmullClark1978] as bicubic patches, Loop
/// [Loop1987] as patches of degree 4 x 4 trimmed to triangles. A quad or a triangle of the cage
/// becomes one face, an n-gon n faces. All patches are the limit surface itself, but the caps in
/// the last ring around an irregular point; Face::approximated bounds their error, a remark tells
/// the largest. Throws Error, one line, for a file that is no sound cage.
SurfaceModel read_subdivision_file(const std::filesystem::path& path, const Job& job = {});

} // namespace keiko
