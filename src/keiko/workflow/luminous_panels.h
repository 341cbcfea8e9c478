#pragma once

#include "keiko/geometry/model/model_mesh.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/light/areas/area_lights.h"
#include "keiko/maps/scene_maps.h"
#include "keiko/scene/material.h"

#include <vector>

namespace keiko {

/// Panels that stand for a face of a placed model with one instance, whose material emits light;
/// they are not shown. A flat face with one outline is a panel, any other its triangles, whose
/// luminance is such that they send the flux of the exact surface within their outline. Of a
/// luminance that maps vary the triangles are smaller, and have its mean each. `mesh`: the face in
/// triangles; `parameters`: those of the model.
std::vector<PolygonLight> luminous_panels(const SurfaceModel& placed, const Face& face,
                                          const FaceMesh& mesh, const Material& material,
                                          const FaceParameters& parameters);

} // namespace keiko
