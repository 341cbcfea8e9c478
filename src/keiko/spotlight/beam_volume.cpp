#include "keiko/spotlight/beam_volume.h"

#include "keiko/base/units.h"
#include "keiko/spotlight/beam_intensity.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Parameters in ]0, 1[ where the line p + t w meets the double cone about `axis`, between 0 and
/// 1, sorted. In components along and across the axis the terms of narrow cones do not cancel.
std::vector<double> crossings(const Vec3& p, const Vec3& w, const Vec3& axis, double half_angle) {
    const double s2 = std::pow(std::sin(half_angle), 2), c2 = std::pow(std::cos(half_angle), 2);
    const double pa = p.dot(axis), wa = w.dot(axis);
    const Vec3 across_p = p - axis * pa, across_w = w - axis * wa;
    const double a = s2 * wa * wa - c2 * across_w.length2();
    const double b = s2 * pa * wa - c2 * across_p.dot(across_w);
    const double c = s2 * pa * pa - c2 * across_p.length2();
    const double q = -(b + std::copysign(std::sqrt(std::max(b * b - a * c, 0.0)), b));
    std::vector<double> ends{0, 1};
    // A double root (a ray through the lamp, a beam of 90 degrees) must not be lost to rounding of
    // the discriminant, hence the 0; where there is no root, or a or q is 0, the end too many is
    // harmless.
    for (const double t : {q / a, c / q})
        if (t > 0 && t < 1) ends.push_back(t);
    std::sort(ends.begin(), ends.end());
    return ends;
}

} // namespace

IntervalSet in_beam(const Spotlight& light, const Segment& segment) {
    if (light.half_angle >= 180) return IntervalSet::whole();
    const Vec3 axis = beam_axis(light);
    const double angle = degrees_to_radians(light.half_angle), cosine = std::cos(angle);
    const Vec3 p = segment.a - light.position, w = segment.b - segment.a;
    const std::vector<double> ends = crossings(p, w, axis, angle);
    std::vector<ParameterInterval> lit;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        // The middle tells the lit nappe from the one behind the lamp.
        const Vec3 middle = p + w * ((ends[i] + ends[i + 1]) / 2);
        if (middle.dot(axis) >= cosine * middle.length()) lit.push_back({ends[i], ends[i + 1]});
    }
    return IntervalSet(std::move(lit));
}

} // namespace keiko
