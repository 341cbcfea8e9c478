#pragma once

#include "keiko/geometry/bezier/bezier.h"

#include <vector>

namespace keiko {

/// Parameters of two plane curves at a place where one crosses the other.
struct CurveCrossing {
    double a = 0, b = 0;
};

/// Result of curve_crossings.
struct CurveCrossings {
    std::vector<CurveCrossing> found; ///< in no order; one on the border of two pieces twice
    bool complete = true;             ///< false: it took too many tests, and more may cross
};

/// The places at which two plane Bezier curves with positive weights cross, by bisection of their
/// hulls and Newton's iteration on nearly straight pieces. Places at which they touch, and
/// pieces that lie on each other, are left out.
CurveCrossings curve_crossings(const BezierCurveView& a, const BezierCurveView& b);

} // namespace keiko
