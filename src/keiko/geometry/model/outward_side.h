#pragma once

#include "keiko/geometry/model/surface_model.h"

namespace keiko {

/// 1 if the normal du x dv of a placed patch at its own parameters `uv` (0 to 1), in the world,
/// points to the outer side of its face, else -1.
inline double outward_side(const SurfaceModel& model, std::uint32_t instance, std::uint32_t patch,
                           const Vec2& uv) {
    const Patch& p = model.patches[patch];
    const bool turned = p.map_u.derivative(uv.x) * p.map_v.derivative(uv.y) < 0;
    const bool inwards = turned != model.faces[p.face].reversed;
    return inwards == model.instances[instance].transform.mirrored() ? 1 : -1;
}

} // namespace keiko
