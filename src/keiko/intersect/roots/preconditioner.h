#pragma once

#include "keiko/intersect/roots/planar_net.h"

#include <optional>

namespace keiko {

/// A net after the change of planes that makes its mean Jacobian the identity, so that f runs
/// with u and g with v. Both strips between parallel planes ("fat lines") become narrow and each
/// clips one parameter. Where the mean Jacobian is singular, e.g. on a closed or symmetric piece,
/// the planes stay as they were.
struct Preconditioned {
    PlanarNet net;                   ///< coefficients of the new f and g
    double slack_f = 0, slack_g = 0; ///< bounds of the coefficients' errors
    bool regular = false;            ///< whether the planes were changed
};

/// `slack` bounds the error of either coefficient of `net`.
Preconditioned preconditioned(const PlanarNet& net, double slack);

/// True if the two functions are proved to have at most one common zero in [0, 1]^2. Every matrix
/// that the bounds of the four partial derivatives allow is then regular, hence the map is
/// injective (mean value form [MooreJones1977]).
bool at_most_one_root(const Preconditioned& p);

/// Bound of how far the Jacobian is from the identity on [0, 1]^2, in the maximum norm. Below 1 a
/// root is no farther from a place than the larger of |f|, |g| there over one less the bound.
double contraction(const Preconditioned& p);

/// A root with a bound of its error.
struct NewtonRoot {
    Vec2 uv;    ///< in [0, 1]^2
    Vec2 error; ///< bound of the distance to the exact root, by rounding and by the last step
};

/// Newton's method for f = g = 0 from `start` in double precision, for a net that has at most one
/// root, in [0, 1]^2. Nothing when it leaves the square, or when its place cannot be proved to be
/// close to a root. The bound comes from the values of f and g there, not from the size of the
/// step.
std::optional<NewtonRoot> newton(const Preconditioned& p, const Vec2& start);

} // namespace keiko
