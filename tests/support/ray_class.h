#pragma once

#include "keiko/geometry/rays/ray.h"

#include "tests/support/random.h"

#include <array>
#include <string>

namespace keiko::test {

/// How a ray is aimed at a known point of a surface.
enum class RayClass {
    random,        ///< any direction
    near_normal,   ///< within some degrees of the normal
    grazing,       ///< 1e-1 to 1e-8 rad to the tangent plane, even in the logarithm
    span_edge,     ///< any direction, at a point where two spans meet or the surface ends
    span_corner,   ///< the same where four meet
    iso_line,      ///< along a line of constant u or v, tilted as `grazing` is
    axis_parallel, ///< two of the direction's components are 0 or -0
};
inline constexpr std::array ray_classes{
    RayClass::random,      RayClass::near_normal, RayClass::grazing,      RayClass::span_edge,
    RayClass::span_corner, RayClass::iso_line,    RayClass::axis_parallel};

/// Place that a ray is aimed at.
struct Mark {
    Vec3 position{0};
    Vec3 normal{0};                  ///< unit
    Vec3 tangent_u{0}, tangent_v{0}; ///< unit
};

/// A ray that passes `mark` as closely as doubles allow, from `distance` mm off. Its direction is
/// not always unit.
Ray ray_at(const Mark& mark, RayClass kind, double distance, Random& random);

/// Exact text of a ray's doubles, to be read back by a compiler.
std::string exact_text(const Ray& ray);

} // namespace keiko::test
