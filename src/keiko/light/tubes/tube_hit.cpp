#include "keiko/light/tubes/tube_hit.h"

#include "keiko/math/interval_set.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace keiko {

namespace {

struct ClosedLampRange {
    int begin = 0, end = -1;
};

/// Slightly more than rounding, so that no tube is missed.
constexpr double slack = 1 + 1e-9;

/// Lamps whose endless tubes the ray's line meets. `o` and `d` are in frame coordinates.
ClosedLampRange candidates(const CPlaneFrame& frame, const Vec3& o, const Vec3& d) {
    const double half = std::hypot(d.y, d.z) / std::abs(d.z) * frame.radius() * slack;
    const double v = o.y - o.z / d.z * d.y, last = frame.lamps - 1;
    if (!std::isfinite(half) || !std::isfinite(v)) return {0, frame.lamps - 1};
    const double lowest = std::ceil((v - half - frame.first) / frame.pitch);
    const double highest = std::floor((v + half - frame.first) / frame.pitch);
    return {static_cast<int>(std::clamp(lowest, 0.0, last + 1)),
            static_cast<int>(std::clamp(highest, -1.0, last))};
}

/// The part of the line inside the endless tube around the u-axis at v = 0, or an empty interval.
ParameterInterval in_tube(double radius, const Vec3& o, const Vec3& d) {
    const double a = d.y * d.y + d.z * d.z, b = o.y * d.y + o.z * d.z;
    const double infinity = std::numeric_limits<double>::infinity();
    const double moment = o.y * d.z - o.z * d.y;
    if (!(a > 0)) {
        const bool inside = o.y * o.y + o.z * o.z <= radius * radius;
        return inside ? ParameterInterval{-infinity, infinity} : ParameterInterval{1, 0};
    }
    const double square = a * radius * radius - moment * moment;
    if (!(square >= 0)) return {1, 0};
    const double root = std::sqrt(square);
    return {(-b - root) / a, (-b + root) / a};
}

/// The part of the line between the planes of the caps, or an empty interval.
ParameterInterval between_caps(double length, double o, double d) {
    if (d == 0) {
        const double infinity = std::numeric_limits<double>::infinity();
        const bool inside = o >= 0 && o <= length;
        return inside ? ParameterInterval{-infinity, infinity} : ParameterInterval{1, 0};
    }
    const double a = -o / d, b = (length - o) / d;
    return {std::min(a, b), std::max(a, b)};
}

} // namespace

std::optional<TubeHit> nearest_tube(const CPlaneFrame& frame, const Vec3& origin,
                                    const Vec3& direction) {
    const Vec3 o = frame.point(origin), d = frame.vector(direction);
    const ParameterInterval slab = between_caps(frame.length, o.x, d.x);
    std::optional<TubeHit> nearest;
    const ClosedLampRange range = candidates(frame, o, d);
    for (int lamp = range.begin; lamp <= range.end; ++lamp) {
        const auto tube = in_tube(frame.radius(), o - Vec3(0, frame.axis(lamp), 0), d);
        const double enter = std::max(tube.begin, slab.begin);
        const bool met = enter > 0 && enter <= std::min(tube.end, slab.end);
        if (met && (!nearest || enter < nearest->t))
            nearest = TubeHit{enter, lamp, slab.begin > tube.begin};
    }
    return nearest;
}

LampRange lamps_in_cone(const CPlaneFrame& frame, const Vec3& point, const Vec3& axis,
                        double half_angle) {
    const LampRange all{0, frame.lamps};
    // Tubes rise from the plane by their radius: a wider cone than at the plane.
    const Vec3 at = frame.point(point), r = frame.vector(axis);
    const double height = std::abs(at.z) + frame.radius();
    const double towards = at.z > 0 ? -r.z : r.z;
    if (!(half_angle < std::numbers::pi / 2) || !(towards > 0)) return all;
    const double c = std::cos(half_angle), k = r.x * r.x + r.y * r.y - c * c;
    const double square =
        towards * towards * r.y * r.y - k * (towards * towards + r.x * r.x - c * c);
    if (!(k < 0) || !(square >= 0)) return all;
    const double a = (-towards * r.y + std::sqrt(square)) / k;
    const double b = (-towards * r.y - std::sqrt(square)) / k;
    const double margin = frame.radius() * (1 + std::hypot(a, b));
    const double low = at.y + height * std::min(a, b) - margin;
    const double high = at.y + height * std::max(a, b) + margin;
    const double first = std::ceil((low - frame.first) / frame.pitch);
    const double last = std::floor((high - frame.first) / frame.pitch);
    return {static_cast<int>(std::clamp(first, 0.0, frame.lamps * 1.0)),
            static_cast<int>(std::clamp(last + 1, 0.0, frame.lamps * 1.0))};
}

} // namespace keiko
