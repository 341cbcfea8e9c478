#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"

#include <vector>

namespace keiko {

/// Control points of the piece of a patch over a box of its parameters, u outer. The box may extend
/// a little beyond [0, 1]^2: the polynomials continue there.
std::vector<Vec4> subpatch(const BezierPatchView& patch, const Box2& box);

} // namespace keiko
