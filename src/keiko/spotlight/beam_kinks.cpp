#include "keiko/spotlight/beam_kinks.h"

#include "keiko/base/units.h"
#include "keiko/spotlight/beam_direction.h"
#include "keiko/spotlight/cone_crossing.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

class KinkFinder {
public:
    KinkFinder(const Spotlight& light, const Segment& segment)
        : frame_(beam_frame(light.aim - light.position, light.reference,
                            degrees_to_radians(light.spin))),
          p_(segment.a - light.position),
          w_(segment.b - segment.a) {}

    /// Half planes every `step` degrees of phi, which may cross twice as far as they reach: a kink
    /// too many is harmless.
    void add_planes(double step) {
        for (int i = 0; i * step < 180; ++i) {
            const double phi = degrees_to_radians(i * step);
            const Vec3 normal = frame_.up * std::cos(phi) - frame_.across * std::sin(phi);
            add(-normal.dot(p_) / normal.dot(w_));
        }
    }
    /// Cones every `step` degrees of theta up to `end`.
    void add_cones(double step, double end) {
        for (int i = 1; i * step < end; ++i)
            for (const double t : cone_crossings(p_, w_, frame_.axis, degrees_to_radians(i * step)))
                add(t);
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

std::vector<double> pattern_kinks(const Spotlight& light, const Segment& segment) {
    KinkFinder finder(light, segment);
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

} // namespace keiko
