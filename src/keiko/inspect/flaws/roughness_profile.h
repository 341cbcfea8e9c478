#pragma once

#include "keiko/inspect/flaws/geodesic_trace.h"

#include <optional>
#include <vector>

namespace keiko {

/// How a surface rises and falls along a straight way, laid out flat: its height has the surface's
/// curvature as second derivative by the way's length. So an even bend of the form is a parabola,
/// however strong, and the angle of a seam does not count.
class RoughnessProfile {
public:
    /// Two and a half waves of `length` mm to either side of a place, less where material ends;
    /// nothing at a pole.
    static std::optional<RoughnessProfile> through(const FaceAdjacency& faces, const SheetPoint& at,
                                                   const Vec3& along, double length);

    /// Whether the profile reaches so far; mm from the place, along the way positive.
    bool holds(double s) const;
    /// mm, outwards; up to a straight line that is the same all along.
    double height(double s) const;
    /// Of the surface.
    SheetPoint place(const FaceAdjacency& faces, double s) const;

private:
    std::vector<WalkPoint> points_; ///< evenly `step_` apart
    std::vector<double> heights_;
    double begin_ = 0, step_ = 1;
};

} // namespace keiko
