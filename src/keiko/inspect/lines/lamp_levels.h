#pragma once

#include "keiko/inspect/basics/line_field.h"

#include <cstdint>
#include <vector>

namespace keiko {

/// The field of one C-plane and its levels, one a lamp. Isophotes have a level of either sign, lamp
/// by lamp, as the normal of a patch may point away from the viewpoint.
struct LampLevels {
    LineField field;
    std::vector<double> levels;
    std::uint32_t lamps = 0;

    /// Value of the field on the line of a lamp, with the normal towards the viewpoint.
    double level(std::uint32_t lamp) const { return levels[lamp]; }
    /// Distance between the levels of neighbouring lamps: the pitch, or for isophotes the step of
    /// the cosine; 0 for a single lamp.
    double step(std::uint32_t lamp) const;
};

/// Levels of all lamps. For reflection and highlight lines they are the lamps' axes, mm; for the
/// isophotes of n lamps the cosines of 90 (i + 1/2) / n degrees.
LampLevels lamp_levels(LineLook look, const LineEye& eye, const CPlane& plane, const Vec3& body);

} // namespace keiko
