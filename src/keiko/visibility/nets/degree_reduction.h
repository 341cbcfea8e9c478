#pragma once

#include "keiko/visibility/nets/tangent_planes.h"

#include <vector>

namespace keiko {

/// A part of a patch, over `uv` of it.
struct ReducedPatch {
    Box2 uv;
    HomogeneousNet points;
};

/// A patch in parts of at most max_occluder_degree either way: itself where it is, or else
/// interpolated in parts so small that, at 11 x 11 places between the nodes, they are within 1e-11
/// of its size, or halved 8 times.
std::vector<ReducedPatch> degree_reduction(HomogeneousNet patch);

} // namespace keiko
