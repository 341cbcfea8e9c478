#include "keiko/light/spotlight/cone_crossing.h"

#include <algorithm>
#include <cmath>

namespace keiko {

std::vector<double> crossings(double a, double b, double c) {
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

std::vector<double> cone_crossings(const Vec3& p, const Vec3& w, const Vec3& axis,
                                   double half_angle) {
    const double cosine = std::cos(half_angle);
    const double s2 = std::pow(std::sin(half_angle), 2), c2 = cosine * cosine;
    const double pa = p.dot(axis), wa = w.dot(axis);
    const Vec3 across_p = p - axis * pa, across_w = w - axis * wa;
    return crossings(s2 * wa * wa - c2 * across_w.length2(),
                     s2 * pa * wa - c2 * across_p.dot(across_w),
                     s2 * pa * pa - c2 * across_p.length2());
}

} // namespace keiko
