#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/import/cad/model_surface.h"

#include <TopoDS_Face.hxx>

namespace keiko::cad {

/// OpenCASCADE's face of a face of the model: the exact surface, bounded by the model's own
/// p-curves. A loop inside of an odd number of others is a hole, however it runs. A face without
/// loops is bounded by its parameters. Throws Standard_Failure.
TopoDS_Face occt_face(const opencascade::handle<ModelSurface>& surface, const SurfaceModel& model,
                      const Face& face);

} // namespace keiko::cad
