#pragma once

#include "keiko/math/quadrature.h"
#include "keiko/math/rgb.h"

#include <algorithm>
#include <cmath>

namespace keiko {

inline double largest_part(double value) {
    return std::abs(value);
}
inline double largest_part(const Rgb& value) {
    return std::max({std::abs(value.r), std::abs(value.g), std::abs(value.b)});
}

/// Integral of f over [a, b] by Gauss panels of 8 and 16 nodes, halved until these agree within
/// `allowed` or `depth` times.
template <class F>
auto integrate_adaptively(const F& f, double a, double b, double allowed, int depth = 12) {
    const auto coarse = integrate(f, a, b, 8), fine = integrate(f, a, b, 16);
    if (depth == 0 || !(largest_part(fine - coarse) > allowed)) return fine;
    const double middle = (a + b) / 2;
    return integrate_adaptively(f, a, middle, allowed / 2, depth - 1) +
           integrate_adaptively(f, middle, b, allowed / 2, depth - 1);
}

} // namespace keiko
