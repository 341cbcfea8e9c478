#pragma once

#include "keiko/base/units.h"
#include "keiko/compare/alignment/surface_samples.h"

#include <limits>
#include <optional>

namespace keiko {

/// A place of the body and its nearest point of the other.
struct DeviationSample : SurfaceSample {
    std::optional<ClosestSurfacePoint> foot; ///< nothing: beyond reach

    double distance() const {
        return foot ? foot->distance : std::numeric_limits<double>::infinity();
    }
    /// Positive outside the other.
    double deviation() const {
        const bool inside = foot && (point.position - foot->position).dot(foot->normal) < 0;
        return inside ? -distance() : distance();
    }
    /// Whether the nearest point lies aside rather than above or below.
    bool beside(double noise) const {
        if (!foot || foot->distance <= noise) return false;
        constexpr double steep = 0.7; // of the way there across the normal
        const Vec3 way = point.position - foot->position;
        return way.cross(foot->normal).length() > steep * foot->distance;
    }
    bool turned() const { return foot && point.normal.dot(foot->normal) < 0; }
    /// Degrees between the tangent planes; 0 beyond a border, where they need not agree.
    double tilt() const {
        if (!foot || foot->on_border || point.normal == Vec3(0) || foot->normal == Vec3(0))
            return 0;
        const Vec3 normal = turned() ? -foot->normal : foot->normal;
        return radians_to_degrees(angle_between(point.normal, normal));
    }
};

} // namespace keiko
