#pragma once

#include "keiko/visibility/nets/affine_bounds.h"
#include "keiko/visibility/nets/scalar_net.h"

namespace keiko {

/// A function over a box, in its [-1, 1]^2: mean slopes, how much they vary, and how much the slope
/// along each axis does, as a share of the slopes.
struct GradientBounds {
    AffineBounds::Weighed all;
    Vec2 bend;

    /// The axis along which halving a box of this size straightens the function more.
    unsigned axis_to_halve(const Vec2& size) const;
    /// Widens the bounds for a function that is a polynomial of the tangent planes' degree and
    /// within `error` of this one on a box of which the sides here are these shares: by Markov's
    /// inequality.
    void add_error(double error, const Vec2& shares);
};

GradientBounds slopes_of(const ScalarNet& net);

} // namespace keiko
