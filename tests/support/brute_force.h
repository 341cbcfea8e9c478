#pragma once

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/geometry/rays/ray.h"

#include <vector>

namespace keiko::test {

/// Parameters of every point where a ray's line meets a patch: halving the patch down to cells of
/// 2^-10 by boxes of the control points across the ray, then Newton on evaluated points. Slow and
/// plain; shares nothing with the tracer but `evaluate`. Roots closer than 1e-6 are one.
std::vector<Vec2> brute_force_roots(const BezierPatchView& patch, const Ray& ray);

} // namespace keiko::test
