#pragma once

#include "keiko/math/vec.h"
#include "keiko/scene/material_map.h"

namespace keiko {

/// Two texture coordinates of a place and their gradients by it, 1/mm.
struct ProjectedPlace {
    Vec2 at{0};                ///< u and v
    Vec3 grad_u{0}, grad_v{0}; ///< by the place

    /// Coordinates times a scale plus an offset, not wrapped.
    ProjectedPlace scaled(const Vec2& scale, const Vec2& offset) const {
        return {at * scale + offset, grad_u * scale.x, grad_v * scale.y};
    }
};

/// Coordinates of a place of the model, mm, by a planar, cylindrical or spherical projection. Its
/// scale and offset are not applied. u of the round ones is in [0, 1), anticlockwise about the
/// axis; v of a sphere is 0 at the pole that the axis points to. On the axis the gradient of u is
/// 0.
ProjectedPlace projected(const MapProjection& projection, const Vec3& place);

/// A coordinate modulo 1: in [0, 1), also of negative ones.
double wrapped(double coordinate);

} // namespace keiko
