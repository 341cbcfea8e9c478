#pragma once

#include "keiko/inspect/flaws/geodesic_trace.h"

#include <optional>
#include <vector>

namespace keiko {

/// Profile of a surface along a geodesic trace, laid out flat. Its height has the surface's
/// curvature as second derivative by the trace's length. A uniform curvature of the form is
/// therefore a parabola, however strong, and the angle of a seam does not count.
class RoughnessProfile {
public:
    /// Two and a half waves of `length` mm to either side of a place, less where material ends;
    /// nullopt at a pole.
    static std::optional<RoughnessProfile> through(const FaceAdjacency& faces, const SheetPoint& at,
                                                   const Vec3& along, double length);

    /// True if the profile reaches `s`: mm from the place, positive along the trace.
    bool holds(double s) const;
    /// mm, outwards; up to a straight line that is fixed for the whole profile.
    double height(double s) const;
    /// Place of the surface.
    SheetPoint place(const FaceAdjacency& faces, double s) const;

private:
    std::vector<WalkPoint> points_; ///< uniformly spaced by `step_`
    std::vector<double> heights_;
    double begin_ = 0, step_ = 1;
};

} // namespace keiko
