#pragma once

#include "keiko/import/subdivision/cage.h"

#include <filesystem>

namespace keiko::subdivision {

/// Reads the polygons of an OBJ file as a control mesh: `v`; `f` with three or more corners
/// "v", "v/vt", "v//vn" or "v/vt/vn", counted from 1 or backwards from -1; `g`, `o` and `usemtl`
/// name the faces after them. `t` holds a tag as OpenSubdiv writes it, "t NAME
/// INTEGERS/FLOATS/STRINGS values", counted from 0. Tags of parts are
///   crease (two vertices or a chain of them; one sharpness or one an edge), corner and hole.
/// Tags of the whole cage are
///   interpolateboundary (0 none, 1 edge and corner, 2 edge only: the default),
///   creasemethod (normal, chaikin), smoothtriangles (catmark, smooth), scheme (catmark, loop).
/// Without `t scheme` a cage of triangles alone is a Loop cage, any other Catmull-Clark's.
/// Texture, normals, points, lines and rendering hints are skipped. Throws Error with the line
/// for anything else, and for a mesh in which an edge has more than two faces or two that run
/// the same way along it.
Cage read_cage(const std::filesystem::path& path);

} // namespace keiko::subdivision
