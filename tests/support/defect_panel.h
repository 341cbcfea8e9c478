#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <array>

namespace keiko::test {

/// Kind of defect that is planted into a panel, and the unit of its size.
enum class Defect {
    dent, ///< mm, depth of nine hollows 80 mm wide
    wave, ///< mm, half the height of waves 100 mm long, over all of it
    kink, ///< degrees, angle at the seam
    bend, ///< 1/m, jump of the curvature at the seam
    ramp  ///< 1/m2, jump of the curvature's slope at the seam
};

/// A gently curved panel of 1000 x 700 mm in two smooth sheets, with a seam across its middle where
/// x is 0. What a defect does at the seam has faded 60 mm beyond it.
SurfaceModel defect_panel(Defect defect, double size);

/// Whether it is one of the seam.
bool is_at_seam(Defect defect);

/// Nine places to search for a defect: all over the panel, or along the seam.
std::array<Vec3, 9> places_of(Defect defect);

} // namespace keiko::test
