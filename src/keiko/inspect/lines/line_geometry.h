#pragma once

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/inspect/basics/line_field.h"

#include <optional>

namespace keiko {

/// Local geometry of a field's line at a place of a surface. Lines are oriented so that the field
/// rises to their left, viewed from the viewpoint's side. docs/theory/reflection-lines.md has the
/// formulas.
struct LineGeometry {
    Vec3 normal{0};   ///< unit, towards the viewpoint
    Vec3 tangent{0};  ///< unit
    double bend = 0;  ///< geodesic curvature, 1/mm, positive to the left
    double value = 0; ///< the field less the level
    /// Length of the field's gradient on the surface: mm on the C-plane a mm on the part, so that
    /// neighbouring lines lie about pitch / density apart.
    double density = 0;
    double spread_along = 0;  ///< relative growth of that spacing along the line, 1/mm
    double spread_across = 0; ///< relative growth to the left, 1/mm

    Vec3 left() const { return normal.cross(tangent); }
    /// Gradient of the field on the surface.
    Vec3 gradient() const { return left() * density; }
};

/// Geometry from the surface's derivatives to order 3; with order 2, all values except bend and
/// spread. nullopt if the surface is singular, the field has a pole or its gradient vanishes.
std::optional<LineGeometry> line_course(const LineField& field, double level,
                                        const SurfaceDerivatives& surface);

/// Error bounds of a line's geometry.
struct LineGeometryBounds {
    double direction = 0; ///< radians, of the tangent
    double bend = 0, value = 0;
};

/// Bounds by interval arithmetic of the same formulas. The derivatives are widened by the rounding
/// of a patch of such a `degree` and by their change within `off` mm of the place. Fourth
/// derivatives, which the latter needs, are estimated by Markov's inequality. Bounds are infinite
/// where the intervals cannot decide.
LineGeometryBounds line_course_bounds(const LineField& field, double level,
                                      const SurfaceDerivatives& surface, int degree, double off);

} // namespace keiko
