#include "keiko/triage/reflection_break.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

double arc_minutes(double radians) {
    return 60 * radians_to_degrees(radians);
}

} // namespace

double image_size(double curvature, const LineOfSight& sight) {
    const double turned = sight.cosine + 2 * curvature * sight.distance;
    if (std::abs(turned) * largest_image <= sight.cosine)
        return std::copysign(largest_image, turned);
    return sight.cosine / turned;
}

double break_of_angle(double angle, double curvature, const LineOfSight& sight) {
    if (!(sight.cosine > 0)) return 0;
    return 60 * 2 * angle * std::abs(image_size(curvature, sight));
}

double break_of_curvatures(double a, double b, const LineOfSight& sight) {
    if (!(sight.cosine > 0)) return 0;
    const double first = image_size(a, sight), second = image_size(b, sight);
    const double smaller = std::min(std::abs(first), std::abs(second));
    const double fineness = std::min(lamp_width * smaller / stripe_width, 1.0);
    return lamp_width * std::abs(first - second) * fineness * fineness;
}

double pooled(double width, double length) {
    return std::pow(width, pooling) * length / pooling_length;
}

double break_of_pooled(double integral) {
    return std::pow(integral, 1 / pooling);
}

double break_of_gap(double gap, const LineOfSight& sight) {
    return arc_minutes(std::atan2(gap, sight.distance));
}

double break_of_gap_angle(double angle) {
    return std::min(60 * angle, lamp_width);
}

} // namespace keiko
