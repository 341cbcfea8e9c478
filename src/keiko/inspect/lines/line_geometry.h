#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/bezier/bezier.h"
#include "keiko/inspect/basics/line_field.h"
#include "keiko/inspect/basics/patch_lines.h"
#include "keiko/inspect/lines/surface_lines.h"

#include <optional>
#include <span>
#include <vector>

namespace KEIKO_API keiko {

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

    /// Unit tangent of the surface, square to the line.
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
    double direction = 0;       ///< radians, of the tangent
    double bend = 0, value = 0; ///< of LineGeometry::bend and LineGeometry::value
};

/// Bounds by interval arithmetic of the same formulas. The derivatives are widened by the rounding
/// of a patch of such a `degree` and by their change within `off` mm of the place. Fourth
/// derivatives, which the latter needs, are estimated by Markov's inequality. Bounds are infinite
/// where the intervals cannot decide.
LineGeometryBounds line_course_bounds(const LineField& field, double level,
                                      const SurfaceDerivatives& surface, int degree, double off);

/// Statistics of a line between two crossings, from its geometry at the points of its pieces.
/// Values are exact there, and the worst of them is reported.
struct LineStatistics {
    double length = 0;   ///< mm
    double turning = 0;  ///< degrees to the left, in total
    double waviness = 0; ///< degrees that it turns back and forth beyond that
    /// Indices of the places after which the line has an inflection, between stretches that turn by
    /// 0.05 degrees or more. There or at the next place its curvature changes its sign.
    std::vector<std::size_t> inflections;
    double largest_bend = 0;  ///< 1/mm, geodesic curvature, signed
    double least_spacing = 0; ///< mm to the next lamp's line, by the gradient; 0: no other lamp
    double most_spacing = 0;  ///< mm, as least_spacing
    double spacing_ratio =
        1; ///< ratio of that spacing and the next one beside, where farthest from 1; >= 1
    double spacing_rate = 0; ///< largest relative change of the spacing along the line, 1/mm
};

/// A place of a line and the line's geometry there.
struct CourseAt {
    double step = 0;     ///< mm from the place before; 0 for the first
    LineGeometry course; ///< of the line there
    LinePoint at;        ///< the place
};

/// Statistics of a line; `step` as returned by LampLevels::step.
LineStatistics line_shape(std::span<const CourseAt> courses, double step);

/// A change of sign of a line's curvature.
struct LineInflection {
    double along = 0; ///< mm, of chords, from where the line begins
    Vec3 place{0};    ///< world, mm, on the exact surface
};

/// Zero of the curvature of the lamp's line between two of its points on a patch, at which it has
/// opposite signs; by halving on the exact surface. `along`: mm from the former.
LineInflection inflection_between(const SurfaceModel& model, const SurfaceLine& piece,
                                  const LampLevels& lamps, const LinePoint& before,
                                  const LinePoint& behind);

} // namespace keiko
