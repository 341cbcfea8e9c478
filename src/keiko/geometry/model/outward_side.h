#pragma once

#include "keiko/geometry/model/surface_model.h"

namespace keiko {

/// 1 if a normal du x dv points to the outer side of its face, else -1. `turned`: one of the
/// patch's parameters alone runs against that of its face; `reversed`: the face is reversed in its
/// file. `mirrored`: its placement mirrors.
constexpr double outward_side(bool turned, bool reversed, bool mirrored) {
    return (turned != reversed) == mirrored ? 1 : -1;
}

/// 1 if the normal du x dv of a placed patch at its own parameters `uv` (0 to 1), in the world,
/// points to the outer side of its face, else -1.
inline double outward_side(const SurfaceModel& model, std::uint32_t instance, std::uint32_t patch,
                           const Vec2& uv) {
    const Patch& p = model.patches[patch];
    const bool turned = p.map_u.derivative(uv.x) * p.map_v.derivative(uv.y) < 0;
    return outward_side(turned, model.faces[p.face].reversed,
                        model.instances[instance].transform.mirrored());
}

} // namespace keiko
