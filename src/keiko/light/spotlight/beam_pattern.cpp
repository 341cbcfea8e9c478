#include "keiko/light/spotlight/beam_pattern.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
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

struct Share {
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
    return std::visit(Share{theta, phi}, pattern);
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

} // namespace keiko
