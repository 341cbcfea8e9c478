#pragma once

#include "keiko/import/cad/surface_patches.h"

#include <functional>
#include <vector>

namespace keiko::cad {

/// A surface known by its points alone.
using SurfacePoint = std::function<Vec3(double u, double v)>;

/// Approximates a surface that has no rational form by polynomial patches of
/// degree 8 that interpolate it at Chebyshev-Lobatto nodes, halved until they are within
/// `tolerance` (mm) between the nodes. `cuts_u`, `cuts_v`: parameters where the surface may be
/// less than smooth, ends of the domain included, ascending. Patches of equal size meet exactly,
/// others within the tolerance. `approximated` is the deviation found, at least `tolerance`.
/// Throws Error when 1/64 of a cut interval is still not fine enough.
SurfacePatches interpolated_patches(const SurfacePoint& surface, const std::vector<double>& cuts_u,
                                    const std::vector<double>& cuts_v, double tolerance);

} // namespace keiko::cad
