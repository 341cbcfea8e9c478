#include "keiko/light/spotlight/point_source.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

double share_of(const PointSource& light, double cosine) {
    switch (light.distribution) {
        case PointDistribution::uniform:
            return 1;
        case PointDistribution::cardioid:
            return (1 + cosine) / 2;
        case PointDistribution::power:
            return cosine > 0 ? std::pow(cosine, light.exponent) : 0;
    }
    return 0;
}

} // namespace

Rgb intensity_towards(const PointSource& light, const Vec3& point) {
    const Vec3 way = point - light.position;
    const double lengths = way.length() * light.axis.length();
    if (!(lengths > 0)) return {};
    return light.intensity * share_of(light, std::clamp(way.dot(light.axis) / lengths, -1.0, 1.0));
}

IntervalSet in_beam(const PointSource& light, const Segment& segment) {
    if (light.distribution != PointDistribution::power) return IntervalSet::whole();
    const double begin = light.axis.dot(segment.a - light.position);
    const double end = light.axis.dot(segment.b - light.position);
    if (begin <= 0 && end <= 0) return {};
    if (begin >= 0 && end >= 0) return IntervalSet::whole();
    const double crossed = begin / (begin - end);
    return begin > 0 ? IntervalSet::whole(0, crossed) : IntervalSet::whole(crossed, 1);
}

double flux_of_unit_intensity(const PointSource& light) {
    constexpr double pi = std::numbers::pi;
    switch (light.distribution) {
        case PointDistribution::uniform:
            return 4 * pi;
        case PointDistribution::cardioid:
            return 2 * pi;
        case PointDistribution::power:
            return 2 * pi / (light.exponent + 1);
    }
    return 0;
}

} // namespace keiko
