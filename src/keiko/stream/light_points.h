#pragma once

#include "keiko/stream/ray_lines.h"
#include "keiko/stream/trace_rays.h"
#include "keiko/workflow/open_scene.h"

namespace keiko {

/// Reads lines of points with normals (see rays_of, `point_header`) and writes the direct
/// illuminance in lx as CSV: a header line, then for each point in order a row of what each source
/// of the scene's rig sheds on it, and their sum; the luminance of coloured light. Columns are
/// named by kind and number of the source, "c_plane.0", and "sum". Rows are written as points come,
/// in constant memory, and are the same bytes for any thread count. A point within 1e-3 mm of
/// a surface is taken to lie on it. Bodies cast shadows if the scene was opened with them. Ends
/// early when the sink wants no more; returns the number of points. Throws Error for a scene
/// without a rig, and without points, and for the first line that is malformed or whose point lies
/// in a lamp, after the rows of those before it.
std::uint64_t light_points(const Scene& scene, const ByteSource& points, const ByteSink& rows,
                           const Job& job = {});

/// Statistics of the illuminance at the points of light_points, as lighting standards require them.
/// Writes a header line, then a row for each
/// column of light_points with the number of points, least, mean and largest illuminance in lx, and
/// the uniformity, the least over the mean (empty in the dark). Writes nothing where light_points
/// throws, but throws the same.
std::uint64_t summarize_points(const Scene& scene, const ByteSource& points, const ByteSink& rows,
                               const Job& job = {});

} // namespace keiko
