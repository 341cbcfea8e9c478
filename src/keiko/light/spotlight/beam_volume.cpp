#include "keiko/light/spotlight/beam_volume.h"

#include "keiko/base/units.h"
#include "keiko/light/spotlight/beam_intensity.h"
#include "keiko/light/spotlight/cone_crossing.h"

#include <cmath>

namespace keiko {
namespace {

/// The pieces between `ends` whose middle is inside: tells the lit nappe from the one behind the
/// lamp.
template <class Inside>
IntervalSet pieces(const std::vector<double>& ends, const Inside& inside) {
    std::vector<ParameterInterval> lit;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
        if (inside((ends[i] + ends[i + 1]) / 2)) lit.push_back({ends[i], ends[i + 1]});
    return IntervalSet(std::move(lit));
}

/// The line p + t w in the cone about `axis`.
IntervalSet in_round_cone(const Vec3& p, const Vec3& w, const Vec3& axis, double half_angle) {
    const double cosine = std::cos(half_angle);
    const auto ends = cone_crossings(p, w, axis, half_angle);
    return pieces(ends, [&](double t) {
        const Vec3 middle = p + w * t;
        return middle.dot(axis) >= cosine * middle.length();
    });
}

/// The same with X^2 + Y^2 < Z^2, Z > 0 in coordinates divided by the tangents of both angles.
IntervalSet in_elliptic_cone(const Vec3& p, const Vec3& w, const BeamFrame& frame, double along,
                             double across) {
    const auto scaled = [&](const Vec3& x) {
        return Vec3(x.dot(frame.across) / std::tan(along), x.dot(frame.up) / std::tan(across),
                    x.dot(frame.axis));
    };
    const Vec3 a = scaled(p), b = scaled(w);
    const auto form = [](const Vec3& x, const Vec3& y) {
        return x.x * y.x + x.y * y.y - x.z * y.z;
    };
    return pieces(crossings(form(b, b), form(a, b), form(a, a)), [&](double t) {
        const Vec3 middle = a + b * t;
        return middle.z > 0 && form(middle, middle) <= 0;
    });
}

} // namespace

IntervalSet in_beam(const Spotlight& light, const Segment& segment) {
    if (light.half_angle >= 180) return IntervalSet::whole();
    const double angle = degrees_to_radians(light.half_angle);
    const Vec3 p = segment.a - light.position, w = segment.b - segment.a;
    if (!light.half_angle_across) return in_round_cone(p, w, beam_axis(light), angle);
    return in_elliptic_cone(p, w, BeamIntensity(light).frame(), angle,
                            degrees_to_radians(*light.half_angle_across));
}

IntervalSet in_beam(const Luminaire& luminaire, const Segment& segment) {
    const double end = luminaire.web->candela.lit_up_to();
    if (luminaire.web->type != PhotometricType::c || end >= 180) return IntervalSet::whole();
    const Vec3 axis = (luminaire.aim - luminaire.position).normalized();
    return in_round_cone(segment.a - luminaire.position, segment.b - segment.a, axis,
                         degrees_to_radians(end));
}

} // namespace keiko
