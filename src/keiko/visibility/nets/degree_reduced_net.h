#pragma once

#include "keiko/visibility/nets/scalar_net.h"

namespace keiko {

/// A homogeneous net in lower degrees than it was given in, with a bound of what that moved it by.
struct DegreeReducedNet {
    HomogeneousNet net;
    Vec4 error{0}; ///< of each component, anywhere on [0, 1]^2
};

/// The least-squares fit of degrees up to `degree`: over a small piece tangent planes need few of
/// their own. The bound is proved by raising the fit to the old degrees again: no function is
/// farther from another than their coefficients are.
DegreeReducedNet lowered(const HomogeneousNet& net, int degree);

/// The same of one function.
struct DegreeReducedScalar {
    ScalarNet net;
    double error = 0; ///< anywhere on [0, 1]^2
};
DegreeReducedScalar lowered(const ScalarNet& net, std::size_t degree);

} // namespace keiko
