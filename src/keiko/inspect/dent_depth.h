#pragma once

#include "keiko/inspect/face_grid.h"

#include <optional>

namespace keiko {

/// How far a face lies off the form around a place.
struct DentDepth {
    double offset = 0; ///< mm, positive outwards: of a bump
    double bound = 0;  ///< mm, by how much it changes when a fifth less around is looked at
    Vec3 position{0};  ///< world, mm
};

/// Climbs from a place of the grid to where the face is furthest off the form within `reach` mm, as
/// SmoothBase has it (docs/theory/inspection.md). `spacing`: of the grid, mm. Nothing beside a
/// border, where there is form on one side only.
std::optional<DentDepth> dent_depth(const FaceGrid& grid, const Vec2& place, double reach,
                                    double spacing);

} // namespace keiko
