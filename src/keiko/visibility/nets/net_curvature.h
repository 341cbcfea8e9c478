#pragma once

#include "keiko/visibility/nets/degree_reduced_net.h"

namespace keiko {

/// Ranges of a function's second derivatives over [-1, 1]^2.
struct NetCurvature {
    NetRange xx, xy, yy;

    /// No zero of the function's gradient but one, whatever the direction.
    bool definite() const;
};

NetCurvature net_curvature(const ScalarNet& net);
/// Of the function that `lowered` approximates, `exact`, cheaper where the approximation is so
/// close that Markov's inequality says enough of its derivatives.
NetCurvature net_curvature(const DegreeReducedScalar& lowered, const ScalarNet& exact);

} // namespace keiko
