#pragma once

#include "keiko/math/vec.h"

namespace keiko {

/// A flat round disc; `normal` is the unit vector of its face, lengths in one unit of any kind.
struct Disc {
    Vec3 center{0};       ///< of the rim
    Vec3 normal{0, 0, 1}; ///< unit vector of its axis
    double radius = 0;    ///< from 0
};

} // namespace keiko
