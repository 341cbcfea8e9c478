#pragma once

#include "keiko/math/vec.h"

#include <functional>
#include <vector>

namespace keiko::subdivision {

/// A point of a surface at parameters (u, v).
using SurfaceSample = std::function<Vec3(double u, double v)>;

/// The tensor Bezier patch of a degree up to 4 through a surface at the (degree + 1)^2 points of
/// the uniform lattice over [0, 1]^2, u outer. Exact, up to rounding, for a polynomial of that
/// degree; a border is exact wherever it is such a polynomial.
std::vector<Vec3> fit_square(int degree, const SurfaceSample& surface);

/// The polynomial of total degree 4 through a surface at the 15 points of the uniform lattice over
/// the triangle u, v, 1 - u - v >= 0; on a border exact wherever the surface is such a polynomial.
SurfaceSample triangle_polynomial(const SurfaceSample& surface);

} // namespace keiko::subdivision
