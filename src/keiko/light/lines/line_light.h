#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/rays/visibility.h"
#include "keiko/math/interval_set.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"

#include <cmath>
#include <optional>

namespace KEIKO_API keiko {

/// A line that shines with the cosine of the angle to its perpendicular, as a thin diffuse tube
/// does: the line source of [Nishita1985].
struct LineLight {
    Vec3 a{0}, b{0, 0, 1000}; ///< ends, mm, apart from each other
    Rgb intensity{1000};      ///< cd/m across the line, colour included

    bool operator==(const LineLight&) const = default;
};

/// A line viewed from a point, by elevations from the perpendicular to it.
struct LineView {
    Vec3 point{0};       ///< mm, from which the line is viewed
    Vec3 along{0};       ///< unit, from end a to end b
    Vec3 across{0};      ///< unit, from the point to the foot on the line
    double distance = 0; ///< mm, of the foot, above 0
    double begin = 0;    ///< mm, of end a from the foot along the line
    double length = 0;   ///< mm

    /// Unit direction under an elevation in radians.
    Vec3 direction(double eta) const { return across * std::cos(eta) + along * std::sin(eta); }
    /// Place of the line under an elevation in radians, mm.
    Vec3 place(double eta) const { return point + (across + along * std::tan(eta)) * distance; }
    /// mm from the foot along the line, of a parameter from 0 at a to 1 at b.
    double x_at(double t) const { return begin + t * length; }
    /// Elevations, radians, of a part of the line by such parameters.
    ParameterInterval elevations(const ParameterInterval& part) const {
        return {std::atan2(x_at(part.begin), distance), std::atan2(x_at(part.end), distance)};
    }
    /// Elevations of a part of the line above the horizon of the unit `normal`; empty
    /// (begin >= end) if there are none.
    ParameterInterval above_horizon(const ParameterInterval& part, const Vec3& normal) const;
};

/// View of a line; nullopt from a point on the straight line through it, which it sends no light.
std::optional<LineView> view_of(const LineLight& light, const Vec3& point);

/// Illuminance in lx of parts of a line with the intensity 1 cd/m at a point with unit `normal`, in
/// closed form (docs/theory/areas.md#points-and-lines). `visible` are parameters from 0 at end a to
/// 1 at end b.
double unit_illuminance(const LineView& view, const Vec3& normal,
                        const IntervalSet& visible = IntervalSet::whole());

/// The line as visibility is queried for it: in front of the light by a millionth of the distance,
/// as a surface that the line is flush with hides nothing of it.
Segment queried_line(const LineLight& light, const Vec3& point);

/// True if a point lies on the line, where its light is undefined.
bool holds(const LineLight& light, const Vec3& point);

} // namespace keiko
