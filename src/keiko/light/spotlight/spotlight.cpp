#include "keiko/light/spotlight/spotlight.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

namespace {

struct ProfileShare {
    const BeamDirection& direction;
    double phi, rim;

    double operator()(const EdgeProfile& profile) const {
        const double soft = rim > 0 ? 1 - direction.versine / rim : 1;
        switch (profile.edge) {
            case BeamEdge::sharp:
                return 1;
            case BeamEdge::soft:
                return soft;
            case BeamEdge::mixed:
                return (1 - profile.q) * soft + profile.q;
        }
        return 0;
    }
    double operator()(const CosinePower& warn) const {
        return direction.versine < 1 ? std::pow(direction.cosine(), warn.exponent) : 0;
    }
    double operator()(const CosinePolynomial& polynomial) const {
        return polynomial_value(polynomial, direction.cosine());
    }
    double operator()(const TableProfile& table) const {
        return (*table)(radians_to_degrees(direction.theta()), radians_to_degrees(phi));
    }
};

} // namespace

double polynomial_value(const CosinePolynomial& polynomial, double x) {
    double value = 0;
    for (auto c = polynomial.coefficients.rbegin(); c != polynomial.coefficients.rend(); ++c)
        value = value * x + *c;
    return std::max(value, 0.0);
}

double profile_share(const BeamProfile& profile, const BeamDirection& direction, double phi,
                     double rim) {
    return direction.versine <= rim ? std::visit(ProfileShare{direction, phi, rim}, profile) : 0;
}

namespace {

using std::numbers::pi;

/// 1 at multiples of `period`, 0 half way between them.
double triangle_wave(double x, double period) {
    const double place = x / period - std::floor(x / period);
    return std::abs(2 * place - 1);
}

/// k of such a wave [NishitaSpots, eq. 10].
double k_of(double wave, double q) {
    return std::max(q + (1 - q) * wave, 0.0);
}

struct PatternShare {
    double theta, phi;

    double operator()(std::monostate) const { return 1; }
    double operator()(const Petals& petals) const {
        return k_of(triangle_wave(phi, 2 * pi / petals.count), petals.q);
    }
    double operator()(const Dots& dots) const {
        const double dphi = degrees_to_radians(dots.dphi), dtheta = degrees_to_radians(dots.dtheta);
        const bool rounded = dots.reading == DotReading::rounded;
        const auto cell = [&](double x) { return rounded ? std::round(x) : std::floor(x); };
        if (std::fmod(cell(phi / dphi) + cell(theta / dtheta), 2) == 0) return 0;
        double along = triangle_wave(theta, dtheta), about = triangle_wave(phi, dphi);
        if (dots.reading == DotReading::centred) along = 1 - along, about = 1 - about;
        return k_of(about, dots.q_phi) * k_of(along, dots.q_theta);
    }
    double operator()(const PhiPolynomial& polynomial) const {
        return polynomial_value(polynomial.in_cosine, std::cos(phi));
    }
};

} // namespace

double pattern_share(const BeamPattern& pattern, double theta, double phi) {
    return std::visit(PatternShare{theta, phi}, pattern);
}

double mean_of_k(double q) {
    return q >= 0 ? (1 + q) / 2 : 1 / (2 * (1 - q));
}

Rgb hue_color(double phi) {
    const double sixth = phi / (pi / 3);
    const auto channel = [sixth](double peak) {
        const double from_peak = std::abs(sixth - peak);
        return std::clamp(2 - std::min(from_peak, 6 - from_peak), 0.0, 1.0);
    };
    return {channel(0), channel(2), channel(4)};
}

namespace {

double versine_of(double angle) {
    const double sine = std::sin(angle / 2);
    return 2 * sine * sine;
}

/// True if the intensity depends on theta alone.
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
