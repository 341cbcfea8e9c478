#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bezier/nurbs.h"

#include <string>

namespace KEIKO_API keiko {

/// Reason why a piece is no curve, in a few words; empty if it is one. The degree of a curve is 1
/// to max_degree, it has points + degree + 1 knots that never fall, its numbers are finite, and its
/// weights positive.
std::string fault_of(const NurbsCurve<Vec4>& piece);

} // namespace keiko
