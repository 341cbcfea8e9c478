#pragma once

#include "keiko/intersect/roots/preconditioner.h"

#include <optional>

namespace keiko {

/// A root with a bound of its error.
struct NewtonRoot {
    Vec2 uv;
    Vec2 error; ///< bound of the distance to the exact root, by rounding and by the last step
};

/// Newton's method for f = g = 0 from `start` in double precision, for a net that has at most one
/// root, in [0, 1]^2. Nothing when it leaves the square, or when its place cannot be proved to be
/// close to a root: the bound comes from what f and g are there, not from how small a step was.
std::optional<NewtonRoot> newton(const Preconditioned& p, const Vec2& start);

} // namespace keiko
