#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/math/bounds.h"

namespace keiko {

/// A box of a patch's parameters as a box of its face's parameters, in which trims are given.
inline Box2 face_box(const SurfaceModel& model, std::uint32_t patch, const Box2& uv) {
    Box2 box;
    box.extend(model.face_parameters(patch, uv.lower));
    box.extend(model.face_parameters(patch, uv.upper));
    return box;
}

} // namespace keiko
