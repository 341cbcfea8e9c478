#pragma once

#include "keiko/math/rgb.h"

#include <string>

namespace keiko {

/// A Lambertian base under a smooth clear coat.
struct Material {
    std::string name;
    Rgb diffuse{0.03};             ///< reflectance of the base, 0 to 1
    double refractive_index = 1.5; ///< of the coat; 1: no coat, no mirror

    bool operator==(const Material&) const = default;
};

} // namespace keiko
