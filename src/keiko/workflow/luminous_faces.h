#pragma once

#include "keiko/base/job.h"
#include "keiko/import/worker/load_model.h"
#include "keiko/light/rig/light_rig.h"
#include "keiko/scene/material.h"

#include <span>
#include <vector>

namespace keiko {

/// The lights of a body's faces whose material, one a face, emits light
/// (docs/theory/areas.md#bodies-as-lamps). Faces of one luminance, of an instance or of those that
/// touch, shine by the contour of the body or of the sheets that they are. Flat ones that hide
/// nothing of each other are panels, see luminous_panels(). So are those with a map, and sheets
/// with a crease inside a face. Lights are not shown, as the body itself is. Throws Error naming a
/// face that cannot be divided into triangles, and as mesh_in_worker does. `deviation`: by which
/// surfaces may leave their triangles, as a share of the second longest side of the box of these
/// faces, which a tube has across; a 32nd of it if all are flat.
std::vector<LightSource> luminous_faces(const SurfaceModel& body,
                                        std::span<const Material> materials,
                                        const LoadOptions& options, const Job& job,
                                        double deviation = 2e-3);

} // namespace keiko
