#pragma once

#include "keiko/visibility/nets/scalar_net.h"
#include "keiko/visibility/nets/tangent_planes.h"

#include <vector>

namespace keiko {

/// A homogeneous net in lower degrees than it was given in, with a bound of what that moved it by.
struct DegreeReducedNet {
    HomogeneousNet net; ///< the fit
    Vec4 error{0};      ///< of each component, anywhere on [0, 1]^2
};

/// The least-squares fit of degrees up to `degree`: over a small piece tangent planes need few of
/// their own. The bound is proved by raising the fit to the old degrees again: no function is
/// farther from another than their coefficients are.
DegreeReducedNet lowered(const HomogeneousNet& net, int degree);

/// One function in reduced degree.
struct DegreeReducedScalar {
    ScalarNet net;    ///< the fit
    double error = 0; ///< anywhere on [0, 1]^2
};
/// Fit of one function of degrees up to `degree`, as that of a net.
DegreeReducedScalar lowered(const ScalarNet& net, std::size_t degree);

/// A part of a patch, over `uv` of it.
struct ReducedPatch {
    Box2 uv;               ///< of the whole patch, in [0, 1]^2
    HomogeneousNet points; ///< control points over `uv`
};

/// Parts of a patch of at most max_occluder_degree either way. They are the patch itself if its
/// degree is low enough. Otherwise they interpolate it and are so small that, at 11 x 11 places
/// between the nodes, they are within 1e-11 of its size, or halved 8 times.
std::vector<ReducedPatch> degree_reduction(HomogeneousNet patch);

} // namespace keiko
