#include "keiko/light/spotlight/point_light.h"

#include "keiko/base/units.h"
#include "keiko/light/spotlight/beam_direction.h"
#include "keiko/light/spotlight/spotlight.h"

#include <algorithm>
#include <cmath>

namespace keiko {

std::vector<double> crossings(double a, double b, double c) {
    const double q = -(b + std::copysign(std::sqrt(std::max(b * b - a * c, 0.0)), b));
    std::vector<double> ends{0, 1};
    // A double root (a ray through the lamp, a beam of 90 degrees) must not be lost to rounding of
    // the discriminant, hence the 0. If there is no root, or a or q is 0, the surplus end is
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

namespace {

/// The pieces between `ends` whose middle is inside: distinguishes the lit nappe from the one
/// behind the lamp.
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

/// The line in the elliptic cone: X^2 + Y^2 < Z^2, Z > 0 in coordinates divided by the tangents of
/// both angles.
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

namespace {

/// Crossings of a segment with the planes through a lamp's axis and the cones about it.
class KinkFinder {
public:
    KinkFinder(const BeamFrame& frame, const Vec3& lamp, const Segment& segment)
        : frame_(frame), p_(segment.a - lamp), w_(segment.b - segment.a) {}

    /// Adds the half plane under phi, in degrees, and the one opposite: a surplus kink is harmless.
    void add_plane(double phi) {
        const double angle = degrees_to_radians(phi);
        const Vec3 normal = frame_.up * std::cos(angle) - frame_.across * std::sin(angle);
        add(-normal.dot(p_) / normal.dot(w_));
    }
    void add_planes(double step) {
        for (int i = 0; i * step < 180; ++i) add_plane(i * step);
    }
    /// Adds the cone under theta, in degrees, and the one opposite.
    void add_cone(double theta) {
        for (const double t : cone_crossings(p_, w_, frame_.axis, degrees_to_radians(theta)))
            add(t);
    }
    void add_cones(double step, double end) {
        for (int i = 1; i * step < end; ++i) add_cone(i * step);
    }
    /// Adds the planes of a table; those that represent others are mirrored.
    void add_planes(const std::vector<double>& degrees, PlaneSymmetry symmetry) {
        if (symmetry == PlaneSymmetry::axial) return;
        const bool whole = symmetry == PlaneSymmetry::none || symmetry == PlaneSymmetry::limited;
        for (const double phi : degrees) {
            add_plane(phi);
            if (!whole) add_plane(-phi);
        }
    }
    std::vector<double> sorted() && {
        std::sort(kinks_.begin(), kinks_.end());
        return std::move(kinks_);
    }

private:
    void add(double t) {
        if (t > 0 && t < 1) kinks_.push_back(t);
    }

    BeamFrame frame_;
    Vec3 p_, w_;
    std::vector<double> kinks_;
};

} // namespace

std::vector<double> intensity_kinks(const Spotlight& light, const Segment& segment) {
    KinkFinder finder(
        beam_frame(light.aim - light.position, light.reference, degrees_to_radians(light.spin)),
        light.position, segment);
    if (const auto* table = std::get_if<TableProfile>(&light.profile)) {
        finder.add_planes((*table)->horizontal(), (*table)->symmetry());
        for (const double theta : (*table)->vertical()) finder.add_cone(theta);
    }
    if (const auto* petals = std::get_if<Petals>(&light.pattern))
        finder.add_planes(180.0 / petals->count);
    if (const auto* dots = std::get_if<Dots>(&light.pattern)) {
        finder.add_planes(dots->dphi / 2);
        finder.add_cones(dots->dtheta / 2,
                         std::max(light.half_angle, light.half_angle_across.value_or(0)));
    }
    if (light.hue) finder.add_planes(60);
    return std::move(finder).sorted();
}

std::vector<double> intensity_kinks(const Luminaire& luminaire, const Segment& segment) {
    const IntensityTable& table = luminaire.web->candela;
    const PhotometricType type = luminaire.web->type;
    const bool type_b = type == PhotometricType::b;
    KinkFinder finder(LuminaireIntensity(luminaire).frame(), luminaire.position, segment);
    finder.add_planes(type_b ? table.vertical() : table.horizontal(),
                      type_b ? PlaneSymmetry::none : table.symmetry());
    for (const double angle : type_b ? table.horizontal() : table.vertical())
        finder.add_cone(type == PhotometricType::c ? angle : 90 - std::abs(angle));
    return std::move(finder).sorted();
}

} // namespace keiko
