#pragma once

#include "keiko/inspect/basics/patch_lines.h"
#include "keiko/inspect/lines/line_geometry.h"
#include "keiko/inspect/lines/surface_lines.h"

#include <span>
#include <vector>

namespace keiko {

/// Statistics of a line between two crossings, from its geometry at the points of its pieces.
/// Values are exact there, and the worst of them is reported.
struct LineStatistics {
    double length = 0;   ///< mm
    double turning = 0;  ///< degrees to the left, in total
    double waviness = 0; ///< degrees that it turns back and forth beyond that
    /// Indices of the courses after which the line has an inflection, between stretches that turn
    /// by 0.05 degrees or more. There or at the next course its curvature changes its sign.
    std::vector<std::size_t> inflections;
    double largest_bend = 0;  ///< 1/mm, geodesic curvature, signed
    double least_spacing = 0; ///< mm to the next lamp's line, by the gradient; 0: no other lamp
    double most_spacing = 0;
    double spacing_ratio =
        1; ///< ratio of that spacing and the next one beside, where farthest from 1; >= 1
    double spacing_rate = 0; ///< largest relative change of the spacing along the line, 1/mm
};

/// A place of a line and the line's geometry there.
struct CourseAt {
    double step = 0; ///< mm from the place before; 0 for the first
    LineGeometry course;
    LinePoint at;
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
