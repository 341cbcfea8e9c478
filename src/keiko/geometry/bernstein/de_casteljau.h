#pragma once

#include <array>
#include <cstddef>

namespace keiko {

// De Casteljau's algorithm on Bernstein coefficients: numbers or control points, in a std::array or
// a std::vector with one at least. The parameter t may lie outside [0, 1].

/// One step: each of the first `count` coefficients becomes the point at t between it and its
/// successor.
template <class Coefficients>
void blend_neighbours(Coefficients& c, std::size_t count, double t) {
    for (std::size_t i = 0; i < count; ++i) c[i] = c[i] * (1 - t) + c[i + 1] * t;
}

/// The value at t.
template <class Coefficients>
auto bernstein_value(Coefficients c, double t) {
    for (std::size_t left = c.size() - 1; left > 0; --left) blend_neighbours(c, left, t);
    return c[0];
}

/// Coefficients of the parts before t and beyond it; they share one.
template <class Coefficients>
std::array<Coefficients, 2> bernstein_parts(const Coefficients& c, double t = 0.5) {
    std::array<Coefficients, 2> parts{c, c};
    auto& [before, beyond] = parts;
    for (std::size_t level = 1; level < c.size(); ++level) {
        blend_neighbours(beyond, c.size() - level, t);
        before[level] = beyond[0];
    }
    return parts;
}

} // namespace keiko
