#include "keiko/light/fog/sight.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

constexpr double endless = std::numeric_limits<double>::infinity();

/// The distance over which a beam falls to a share of itself, at most 1.
double distance_to_share(double share, double extinction) {
    if (!(share < 1)) return 0;
    return extinction > 0 ? -std::log(share) / extinction : endless;
}

/// The solution w of w exp(w) = x >= 0, Lambert's W0, by Halley's method [Corless1996].
double lambert_w(double x) {
    constexpr int most_steps = 20;
    double w = std::log1p(x); // never below the solution
    for (int step = 0; step < most_steps; ++step) {
        const double rest = w - x * std::exp(-w);
        const double change = rest / (1 + w - rest * (2 + w) / (2 * (1 + w)));
        w -= change;
        if (std::abs(change) <= 1e-16 * w) break;
    }
    return w;
}

} // namespace

double visual_range(double contrast, double extinction, double least) {
    return distance_to_share(least / std::abs(contrast), extinction);
}

double meteorological_range(double extinction) {
    constexpr double left = 0.05; // [WMO2018]
    return distance_to_share(left, extinction);
}

double signal_illuminance(double intensity, double extinction, double distance) {
    return intensity * std::exp(-extinction * distance) / (distance * distance);
}

double signal_range(double intensity, double extinction, double least) {
    const double in_clear_air = std::sqrt(intensity / least);
    if (!(extinction > 0)) return in_clear_air;
    return 2 / extinction * lambert_w(extinction / 2 * in_clear_air);
}

double required_intensity(double least, double extinction, double distance) {
    return least * distance * distance * std::exp(extinction * distance);
}

double sign_contrast(const SignLuminances& sign, double passed, double added) {
    const double difference = (sign.legend - sign.panel) * passed;
    if (difference == 0) return 0;
    return difference / (sign.panel * passed + added);
}

double legible_range(const SignLuminances& sign, double extinction, double least) {
    const double difference = std::abs(sign.legend - sign.panel);
    if (!(difference > least * sign.panel)) return 0;
    if (!(sign.airlight > 0)) return endless;
    // From difference T = least (panel T + airlight (1 - T)).
    const double share =
        least * sign.airlight / (difference + least * (sign.airlight - sign.panel));
    return distance_to_share(share, extinction);
}

} // namespace keiko
