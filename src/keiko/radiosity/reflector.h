#pragma once

#include "keiko/base/export.h"
#include "keiko/math/rgb.h"

namespace KEIKO_API keiko {

/// Diffuse reflection and own light of an element, uniform over it.
struct Reflector {
    Rgb reflectance; ///< 0 to below 1, each channel
    Rgb exitance;    ///< lm/m2 that it emits, or reflects of lamps that are no elements; from 0
};

} // namespace keiko
