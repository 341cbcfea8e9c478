#pragma once

#include "keiko/base/export.h"

/// Laws of seeing through a uniform medium. Extinctions are in 1/m, distances in m; without
/// extinction what can be seen at all is seen at any distance.
namespace KEIKO_API keiko {

/// Least stimuli that an eye can see.
struct SightLimits {
    double contrast = 0.05; ///< least luminance contrast, > 0; 0.05 is that of [WMO2018]
    double lux = 2e-7; ///< least illuminance at the eye of a lamp that is a point, > 0: at night
};

/// Contrast of a luminance against another, > 0, both in cd/m2: (L - L_b) / L_b
/// [Koschmieder1924].
inline double luminance_contrast(double luminance, double background) {
    return (luminance - background) / background;
}

/// Distance at which the contrast of an object against the horizon has sunk to the least one:
/// ln(|C0| / least) / extinction [Koschmieder1924]; 0 if it is not more from near.
double visual_range(double contrast, double extinction, double least);

/// Distance over which 5 % of the light of a beam are left, the meteorological optical range.
double meteorological_range(double extinction);

/// Illuminance in lx at the eye by a lamp of `intensity` cd: I exp(-extinction d) / d^2
/// [Allard1876].
double signal_illuminance(double intensity, double extinction, double distance);

/// Distance at which that illuminance has sunk to `least` lx > 0.
double signal_range(double intensity, double extinction, double least);

/// Intensity in cd that gives `least` lx at a distance.
double required_intensity(double least, double extinction, double distance);

/// Luminances of a sign from near and of an infinite depth of the air before it, cd/m2.
struct SignLuminances {
    double legend = 0;   ///< of its text or symbol
    double panel = 0;    ///< around it
    double airlight = 0; ///< that the medium's own light tends to
};

/// Contrast of the legend against the panel where `passed` of their light, above 0 to 1, is left
/// and the air adds `added` cd/m2. Infinite against black.
double sign_contrast(const SignLuminances& sign, double passed, double added);

/// Distance at which that contrast has sunk to `least`; infinite in air that adds nothing, 0 if it
/// is not more from near.
double legible_range(const SignLuminances& sign, double extinction, double least);

} // namespace keiko
