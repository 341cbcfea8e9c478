#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/import/cad/face_conversion.h"

#include <span>

namespace keiko::cad {

/// Appends a part with all its faces, numbered on from those already there, to `model`. A face
/// that could not be converted goes to the lost ones with its reason; repairs are listed. Takes
/// what was converted out of `faces`.
void append_part(SurfaceModel& model, const CadPart& part, std::span<FaceResult> faces);

/// Makes room in `model` for all that append_part will add of these faces.
void reserve(SurfaceModel& model, std::span<const FaceResult> faces);

/// Number of faces of a shape; one that two solids share counts once.
std::size_t face_count(const TopoDS_Shape& shape);

} // namespace keiko::cad
