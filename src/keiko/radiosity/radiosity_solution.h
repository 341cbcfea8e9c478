#pragma once

#include "keiko/base/export.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"
#include "keiko/radiosity/energy_balance.h"

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// Reflected light at one face of an element.
struct ElementLight {
    Rgb arriving;  ///< lx from the other elements
    Rgb radiosity; ///< lm/m2 that leave it, direct light of lamps reflected once included
};

/// Reflected light of a scene (keiko-solution/1), for its views and points.
struct RadiositySolution {
    std::string geometry;      ///< SHA-256 of the visible geometry that it was made of
    std::string lighting;      ///< SHA-256 of its lamps and the reflectances of its faces
    double remaining = 0;      ///< bound of the light that it lacks, as a share of its own
    EnergyBalance balance;     ///< of its light
    std::vector<Vec3> corners; ///< world, mm
    std::vector<std::array<std::uint32_t, 3>> triangles; ///< indices of corners
    std::vector<std::array<ElementLight, 2>> light;      ///< a triangle: of its front and its back
};

} // namespace keiko
