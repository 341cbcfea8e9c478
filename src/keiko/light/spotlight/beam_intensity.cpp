#include "keiko/light/spotlight/beam_intensity.h"

#include "keiko/base/units.h"

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

double versine_of(double angle) {
    const double sine = std::sin(angle / 2);
    return 2 * sine * sine;
}

/// Whether the intensity depends on theta alone.
bool axial(const Spotlight& light) {
    const auto* table = std::get_if<TableProfile>(&light.profile);
    return std::holds_alternative<std::monostate>(light.pattern) && !light.hue &&
           !(table && (*table)->horizontal().size() > 1);
}

} // namespace

BeamIntensity::BeamIntensity(const Spotlight& light)
    : light_(light),
      frame_(beam_frame(light.aim - light.position, light.reference)),
      rim_(versine_of(degrees_to_radians(light.half_angle))) {}

double BeamIntensity::rim(double phi) const {
    if (!light_.half_angle_across) return rim_;
    const double along = std::cos(phi) / std::tan(degrees_to_radians(light_.half_angle));
    const double across = std::sin(phi) / std::tan(degrees_to_radians(*light_.half_angle_across));
    return versine_of(std::atan2(1, std::hypot(along, across)));
}

Rgb BeamIntensity::towards(const BeamDirection& direction) const {
    if (axial(light_) && !light_.half_angle_across)
        return light_.intensity * profile_share(light_.profile, direction, 0, rim_);
    const double geometric = direction.phi(), rim = this->rim(geometric);
    if (!(direction.versine <= rim)) return {};
    const double turn = 2 * std::numbers::pi;
    double phi = std::fmod(geometric + degrees_to_radians(light_.spin), turn);
    if (phi < 0) phi += turn;
    Rgb cd = light_.intensity * profile_share(light_.profile, direction, phi, rim);
    if (!std::holds_alternative<std::monostate>(light_.pattern))
        cd *= pattern_share(light_.pattern, direction.theta(), phi);
    return light_.hue ? cd * hue_color(phi) : cd;
}

Rgb BeamIntensity::operator()(const Vec3& point) const {
    const Vec3 beam = point - light_.position;
    const double distance = beam.length();
    if (!(distance > 0)) return {};
    return towards(frame_.direction(beam / distance));
}

Rgb intensity_towards(const Spotlight& light, const Vec3& point) {
    return BeamIntensity(light)(point);
}

} // namespace keiko
