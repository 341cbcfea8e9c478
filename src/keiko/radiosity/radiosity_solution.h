#pragma once

#include "keiko/base/export.h"
#include "keiko/math/rgb.h"
#include "keiko/math/vec.h"
#include "keiko/radiosity/energy_balance.h"
#include "keiko/radiosity/solved_triangle.h"

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace KEIKO_API keiko {

/// A quantity on the front and on the back of a surface.
using BothSides = std::array<Rgb, 2>;

/// Light that surfaces reflect of one lamp at the level 1, direct light not included.
struct LampSolution {
    std::vector<BothSides> arriving; ///< lx at each corner
    std::vector<BothSides> exitance; ///< lm/m2 of each element by direct light of the lamp alone
};

/// Reflected light of a scene (keiko-solution/1), for its views and points.
struct RadiositySolution {
    std::string geometry;        ///< SHA-256 of the visible geometry that it was made of
    std::string lighting;        ///< SHA-256 of reflectances and of its lamps without their levels
    double remaining = 0;        ///< bound of the light that it lacks, as a share of its own
    std::size_t factor_rows = 0; ///< rows of form factors that were computed for it
    double element_size = 0;     ///< mm, largest of elements on bodies
    EnergyBalance balance;       ///< of its light, at the levels of the lamps when it was solved
    std::vector<Vec2> corners;   ///< face parameters
    std::vector<SolvedTriangle> triangles; ///< by corners and elements
    std::size_t elements = 0;              ///< their number
    std::vector<LampSolution> lamps;       ///< a source of the rig, in its order
};

} // namespace keiko
