#pragma once

#include "keiko/math/vec.h"

#include <string>
#include <string_view>
#include <vector>

namespace keiko {

// The points in the bytes of a scan, one function a format. Each throws Error naming `file`.

/// Corners of the triangles of STL, ASCII or binary, each place once.
std::vector<Vec3> stl_points(std::string_view bytes, const std::string& file);

/// Vertices of PLY, of all three encodings.
std::vector<Vec3> ply_points(std::string_view bytes, const std::string& file);

/// The first three numbers of each line, between blanks, commas or semicolons. Comments begin with
/// '#' or "//"; one line of words and one with a count may come first.
std::vector<Vec3> column_points(std::string_view bytes, const std::string& file);

} // namespace keiko
