#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <filesystem>

namespace keiko {

/// Reads a .bpt file: the number of patches, then for each patch a line with its two degrees and
/// (degree_u + 1) (degree_v + 1) lines of points, u outer. A point is "x y z", or "x y z w" in a
/// rational patch, where x, y, z are the point itself, not multiplied by w. The first point of a
/// patch decides for all of it. Blank lines and text after # are skipped; commas count as blanks.
/// Each patch becomes a face with its border as trim loop. Throws Error with the line for anything
/// else: counts that the file cannot hold, degrees out of 1 to 25, numbers that are not finite,
/// coordinates beyond +-1e15, weights beyond 1e-15 to 1e15.
SurfaceModel read_bezier_file(const std::filesystem::path& path);

/// Reads the classic text of the Newell teapot: the number of patches, 16 vertex numbers (from 1)
/// for each bicubic patch, the number of vertices, "x, y, z" for each. Errors as above.
SurfaceModel read_teapot_file(const std::filesystem::path& path);

} // namespace keiko
