#pragma once

#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/math/bounds.h"
#include "keiko/math/interval_set.h"

#include <array>
#include <optional>
#include <span>

namespace keiko {

/// A sub-patch seen along a ray: Bernstein coefficients over [0, 1]^2 of two functions f and g, the
/// distances to two planes through the ray times the weight. The ray meets the sub-patch where both
/// are zero. The weight needs no division: where it is positive, it has no say in the zeros.
struct PlanarNet {
    /// Most coefficients of a function.
    static constexpr std::size_t capacity = std::size_t{max_degree + 1} * (max_degree + 1);

    int degree_u, degree_v; ///< 0 to max_degree, not set by default
    /// u outer; entries beyond the degrees are undefined, for nets are made by the million.
    std::array<double, capacity> f, g;

    /// Number of coefficients along v: degree_v + 1.
    std::size_t columns() const { return static_cast<std::size_t>(degree_v) + 1; }
    /// Number of coefficients along u: degree_u + 1.
    std::size_t rows() const { return static_cast<std::size_t>(degree_u) + 1; }
    /// Number of coefficients of either function that are in use.
    std::size_t size() const { return rows() * columns(); }
};

/// The coefficients of the same functions over a box of the parameters (blossoming).
PlanarNet restricted(const PlanarNet& net, const Box2& box);

/// (f, g) and its partial derivatives at one place.
struct PlanarPoint {
    Vec2 value;  ///< (f, g)
    Vec2 du, dv; ///< derivatives of (f, g) by u and by v

    /// Determinant of the Jacobian, f_u g_v - g_u f_v.
    double determinant() const { return du.x * dv.y - du.y * dv.x; }
};

/// The two functions and their first derivatives at `uv`, inside or outside of [0, 1]^2.
PlanarPoint evaluate(const PlanarNet& net, const Vec2& uv);

/// How much the two functions vary along u and along v, summed along the steepest line.
Vec2 variation(const PlanarNet& net);

/// A plane through the ray in which the whole piece lies to within `slack`, as its coordinates in
/// the normals of the two planes of the net.
std::optional<Vec2> containing_plane(const PlanarNet& net, double slack);

/// Which of a net's two parameters.
enum class Axis {
    u, ///< along the rows
    v  ///< along the columns
};

/// Range along one axis of [0, 1]^2 that holds all zeros of a function: the convex hull of its
/// coefficients, cut with the zero line [SederbergNishita1990, section 3]. Each coefficient is
/// widened by `slack`, a bound of their rounding errors. Empty (begin > end) when the function has
/// no zero. `net` has `rows` x `columns` Bernstein coefficients, u outer.
ParameterInterval clip_interval(std::span<const double> net, std::size_t rows, std::size_t columns,
                                Axis axis, double slack);

} // namespace keiko
