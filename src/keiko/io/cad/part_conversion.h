#pragma once

#include "keiko/io/cad/cad_document.h"
#include "keiko/patch/surface_model.h"

#include <functional>

namespace keiko::cad {

/// Appends a part with all its faces, numbered on from those already there, to `model`. A face
/// that cannot be converted goes to the lost ones with its reason; repairs are listed. `face_done`
/// is called after each face.
void append_part(SurfaceModel& model, const CadPart& part, const std::function<void()>& face_done);

/// Number of faces of a shape; one that two solids share counts once.
std::size_t face_count(const TopoDS_Shape& shape);

/// The reason of the exception being handled, one line. Lack of memory is thrown on: it is not
/// the fault of one face.
std::string current_failure();

} // namespace keiko::cad
