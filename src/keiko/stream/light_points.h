#pragma once

#include "keiko/base/export.h"
#include "keiko/stream/ray_lines.h"
#include "keiko/stream/trace_rays.h"
#include "keiko/workflow/open_scene.h"

#include <span>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Reads lines of points with normals (see rays_of, `point_header`) and writes the illuminance in
/// lx as CSV. After a header line each point, in order, has a row: the direct illuminance by each
/// source of the scene's rig, that by surfaces if the scene has a solution, and their sum. For
/// coloured light it is the luminance. Columns are named by kind and number of the source,
/// "c_plane.0", then "reflected" and "sum". Rows are
/// written as points come, in constant memory, and are the same bytes for any thread count. A point
/// within 1e-3 mm of a surface counts as on it. Bodies cast shadows if the scene was opened with
/// them. Ends early if the sink accepts no more; returns the number of points. Throws Error for a
/// scene without a rig, and without points. It also throws for the first line that is malformed or
/// whose point lies in a lamp or in a focus of caustics, after the rows of those before it.
std::uint64_t light_points(const Scene& scene, const ByteSource& points, const ByteSink& rows,
                           const Job& job = {});

/// Illuminance at points, lx.
struct PointIlluminance {
    std::vector<std::string> columns; ///< as light_points names them, "sum" last
    std::vector<double> lux;          ///< a row a point, of as many numbers as there are columns
};

/// The numbers of light_points at points whose ray goes along the normal, under `rig`. Throws
/// FieldError of "points" for one that light_points would refuse.
PointIlluminance illuminance_at(const Scene& scene, const LightRig& rig,
                                std::span<const Ray> points, const Job& job = {});

/// Statistics of the illuminance at the points of light_points, as lighting standards require them.
/// Writes a header line, then a row for each column of light_points. A row has the number of
/// points, least, mean and largest illuminance in lx, and the uniformity, the least over the mean
/// (empty in the dark). Where light_points throws, it throws the same and writes nothing.
std::uint64_t summarize_points(const Scene& scene, const ByteSource& points, const ByteSink& rows,
                               const Job& job = {});

} // namespace keiko
