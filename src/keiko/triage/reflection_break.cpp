#include "keiko/triage/reflection_break.h"

#include "keiko/base/units.h"

#include <cmath>

namespace keiko {
namespace {

double arc_minutes(double radians) {
    return 60 * radians_to_degrees(radians);
}

/// Ratio of an angle that the eye sees on a body of this curvature to the same on a plane.
double shrinking(double curvature, const LineOfSight& sight) {
    return sight.cosine / (sight.cosine + 2 * std::abs(curvature) * sight.distance);
}

} // namespace

double break_of_angle(double angle, double curvature, const LineOfSight& sight) {
    if (!(sight.cosine > 0)) return 0;
    return 60 * 2 * angle * shrinking(curvature, sight);
}

double break_of_curvatures(double a, double b, const LineOfSight& sight) {
    if (!(sight.cosine > 0)) return 0;
    return lamp_width * std::abs(shrinking(a, sight) - shrinking(b, sight));
}

double break_of_gap(double gap, const LineOfSight& sight) {
    return arc_minutes(std::atan2(gap, sight.distance));
}

} // namespace keiko
