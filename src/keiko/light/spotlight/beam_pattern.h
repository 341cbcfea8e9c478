#pragma once

#include "keiko/light/spotlight/beam_profile.h"
#include "keiko/math/rgb.h"

#include <variant>

namespace keiko {

/// Petals k(phi) [NishitaSpots, eq. 11], bright at multiples of 360 degrees / count, dark between
/// them.
struct Petals {
    int count = 12;
    double q = 0; ///< below 1: their least brightness, where it is not negative; less: narrower

    bool operator==(const Petals&) const = default;
};

/// Readings of the polka dots of [NishitaSpots, eq. 12].
enum class DotReading {
    centred, ///< each dot is bright in its middle (docs/theory/spotlights.md#patterns)
    rounded, ///< [x] of the paper is the nearest integer: dots about multiples of the periods
    literal  ///< as printed: each dot falls into two opposite quarters
};

/// Polka dots: every second cell of a grid in phi and theta.
struct Dots {
    double dphi = 30, dtheta = 4;  ///< degrees; dphi divides 360 an even number of times
    double q_phi = 0, q_theta = 0; ///< below 1; smaller ones make smaller dots
    DotReading reading = DotReading::centred;

    bool operator==(const Dots&) const = default;
};

/// A polynomial in cos phi, not below 0.
struct PhiPolynomial {
    CosinePolynomial in_cosine;

    bool operator==(const PhiPolynomial&) const = default;
};

/// What multiplies a beam's profile, by direction.
using BeamPattern = std::variant<std::monostate, Petals, Dots, PhiPolynomial>;

/// Share of the profile that is left under angles in radians, phi from 0 to 2 pi.
double pattern_share(const BeamPattern& pattern, double theta, double phi);

/// Mean of k over a period [NishitaSpots, eq. 10]: (1 + q) / 2, or 1 / (2 (1 - q)) below q = 0.
double mean_of_k(double q);

/// HSV(phi / 360 degrees, 1, 1) as linear colour; phi in radians, 0 to 2 pi.
Rgb hue_color(double phi);

} // namespace keiko
