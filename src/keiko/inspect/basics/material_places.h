#pragma once

#include "keiko/geometry/trim/trim_region.h"

namespace keiko {

/// Calls `visit(patch, uv)` for the places of a face's material in a grid of `steps` x `steps` on
/// each of its patches: the number of the patch in the model, and patch parameters.
template <class Visit>
void each_material_place(const SurfaceModel& model, const Face& face, int steps,
                         const Visit& visit) {
    const TrimRegion trims(model, face);
    for (std::uint32_t k = face.first_patch; k < face.first_patch + face.patch_count; ++k)
        for (int a = 0; a < steps; ++a)
            for (int b = 0; b < steps; ++b) {
                const Vec2 uv((a + 0.5) / steps, (b + 0.5) / steps);
                if (trims.untrimmed() || trims.contains(model.face_parameters(k, uv))) visit(k, uv);
            }
}

} // namespace keiko
