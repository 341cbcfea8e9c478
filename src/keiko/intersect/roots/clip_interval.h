#pragma once

#include "keiko/math/interval_set.h"

#include <span>

namespace keiko {

/// Which of a net's two parameters.
enum class Axis { u, v };

/// Range along one axis of [0, 1]^2 that holds all zeros of a function: the convex hull of its
/// coefficients, cut with the zero line [SederbergNishita1990, section 3]. Each coefficient is
/// widened by `slack`, a bound of their rounding errors. Empty (begin > end) when the function has
/// no zero. `net` has `rows` x `columns` Bernstein coefficients, u outer.
ParameterInterval clip_interval(std::span<const double> net, std::size_t rows, std::size_t columns,
                                Axis axis, double slack);

} // namespace keiko
