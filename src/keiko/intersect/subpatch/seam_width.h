#pragma once

#include "keiko/geometry/bezier/parameter_metric.h"
#include "keiko/intersect/subpatch/traced_model.h"

namespace keiko {

/// A seam's width says how far the neighbour's border may be in space. A ray that passes the border
/// within it may meet the surface much farther off, in the ratio of the sine of its angle
/// to the surface; so the distance of a root to a border is measured as the ray sees it, with
/// lengths along the ray seen this many times shorter.
constexpr double seam_depth = 16;

/// The metric of a patch's face parameters at `uv` for a ray: from the tangents by the patch's
/// parameters and the ray's unit direction, all in the part's coordinates.
inline ParameterMetric seam_width(const PatchFrame& patch, const Vec2& uv, const Vec3& du,
                                  const Vec3& dv, const Vec3& direction) {
    const auto seen = [&](const Vec3& tangent) {
        return tangent - direction * (direction.dot(tangent) * (1 - 1 / seam_depth));
    };
    return {seen(du) / patch.map_u.derivative(uv.x), seen(dv) / patch.map_v.derivative(uv.y)};
}

} // namespace keiko
