#pragma once

#include "keiko/base/export.h"
#include "keiko/film/value_range.h"
#include "keiko/geometry/model/curve_set.h"
#include "keiko/geometry/model/surface_mesh.h"
#include "keiko/math/rgb.h"

#include <optional>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// The range of the colours of a field: symmetric about 0, so that 98 % of the values lie within,
/// and rounded up.
ValueRange color_range(const MeshField& field);

/// Display colour of each corner: that of the mesh's first field as in pictures, from blue below 0
/// over grey to red; grey without a field, dark grey where it has no number.
std::vector<Rgb> corner_colors(const SurfaceMesh& mesh, const std::optional<ValueRange>& range);

/// Bytes of a VTK XML file (.vtp) of triangles, with normals and all fields at the corners and the
/// face numbers of the triangles; numbers are binary doubles.
std::string vtp_file(const SurfaceMesh& mesh);
/// Bytes of a VTK XML file (.vtp) of curves as polylines that leave them by at most `chord_error`
/// mm. Each has its number, its deviation in mm with that of the chords, and its colour; the names
/// stand in the field data, by number.
std::string vtp_file(const CurveSet& curves, double chord_error);
/// Bytes of a binary PLY file: positions as doubles, normals, colours, the fields, and the face
/// numbers of the triangles.
std::string ply_file(const SurfaceMesh& mesh, const std::optional<ValueRange>& range);
/// Bytes of a binary glTF 2.0 file (.glb) with colours at the corners, in metres and y upwards as
/// that format wants. It is for showing: numbers are floats. Throws Error for more than 4 GB.
std::string glb_file(const SurfaceMesh& mesh, const std::optional<ValueRange>& range);

} // namespace keiko
