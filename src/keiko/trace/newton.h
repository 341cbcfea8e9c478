#pragma once

#include "keiko/trace/planar_net.h"

#include <optional>

namespace keiko {

/// Where Newton's method came to rest.
struct NewtonRoot {
    Vec2 uv;
    Vec2 error; ///< bound of the distance to the exact root, by rounding and by the last step
};

/// Newton's method for f = g = 0 in double precision from `start`; nothing when it leaves `box`
/// (by more than the root's own error) or does not settle. `slack` bounds the error of a
/// coefficient of the net.
std::optional<NewtonRoot> newton(const PlanarNet& net, const Vec2& start, const Box2& box,
                                 double slack);

} // namespace keiko
