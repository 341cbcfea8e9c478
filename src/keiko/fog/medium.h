#pragma once

#include "keiko/math/rgb.h"

namespace keiko {

/// A homogeneous medium that scatters light once.
struct Medium {
    Rgb extinction{0};  ///< 1/m, absorption and scattering together
    Rgb albedo{0.9};    ///< share of the extinction that is scattering
    Rgb ambient{0};     ///< cd/m2 that an infinite depth of it shows
    double phase_k = 0; ///< phase function 1 + k cos^16(gamma / 2), normalised; 0: isotropic
};

} // namespace keiko
