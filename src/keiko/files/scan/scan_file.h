#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

#include <filesystem>
#include <vector>

namespace KEIKO_API keiko {

/// True if a name has the ending of a scan: .stl, .ply, .asc or .xyz, in any case.
bool is_scan_file(const std::filesystem::path& path);

/// The points of a scan in the order of the file, mm. Those of an STL file are the corners of its
/// triangles, each place once. Those of a PLY file are its vertices, and of an ASC or XYZ file the
/// first three numbers of each line. `millimetres`: those in one unit of the file. Throws Error
/// naming file, place and reason for a file that cannot be read, is cut short or holds no point.
/// The same holds for a coordinate that is not finite or beyond 1e9 units.
std::vector<Vec3> read_scan(const std::filesystem::path& path, double millimetres = 1);

} // namespace keiko
