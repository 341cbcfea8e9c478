#include "keiko/light/spotlight/beam_kinks.h"

#include "keiko/base/units.h"
#include "keiko/light/spotlight/beam_direction.h"
#include "keiko/light/spotlight/cone_crossing.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Crossings of a segment with the planes through a lamp's axis and the cones about it.
class KinkFinder {
public:
    KinkFinder(const BeamFrame& frame, const Vec3& lamp, const Segment& segment)
        : frame_(frame), p_(segment.a - lamp), w_(segment.b - segment.a) {}

    /// The half plane under phi, in degrees, and the one opposite: a kink too many is harmless.
    void add_plane(double phi) {
        const double angle = degrees_to_radians(phi);
        const Vec3 normal = frame_.up * std::cos(angle) - frame_.across * std::sin(angle);
        add(-normal.dot(p_) / normal.dot(w_));
    }
    void add_planes(double step) {
        for (int i = 0; i * step < 180; ++i) add_plane(i * step);
    }
    /// The cone under theta, in degrees, and the one opposite.
    void add_cone(double theta) {
        for (const double t : cone_crossings(p_, w_, frame_.axis, degrees_to_radians(theta)))
            add(t);
    }
    void add_cones(double step, double end) {
        for (int i = 1; i * step < end; ++i) add_cone(i * step);
    }
    /// The planes of a table, those that stand for others mirrored.
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
