#pragma once

#include "keiko/inspect/basics/line_field.h"

#include <cstdint>
#include <vector>

namespace keiko {

/// The field of one C-plane and its levels: one a lamp, of isophotes both signs, lamp by lamp, as
/// the normal of a patch may turn away from the eye.
struct LampLevels {
    LineField field;
    std::vector<double> levels;
    std::uint32_t lamps = 0;

    /// Value of the field, with the normal towards the eye, on the line of a lamp.
    double level(std::uint32_t lamp) const { return levels[lamp]; }
    /// How far the level of the next lamp is from that of this one: the pitch, or for isophotes
    /// the step of the cosine; 0 for a single lamp.
    double step(std::uint32_t lamp) const;
};

/// Reflection and highlight lines have the lamps' axes for levels, mm; the isophotes of n lamps
/// the cosines of 90 (i + 1/2) / n degrees.
LampLevels lamp_levels(LineLook look, const LineEye& eye, const CPlane& plane, const Vec3& body);

} // namespace keiko
