#pragma once

#include "keiko/inspect/flaws/face_adjacency.h"

#include <optional>

namespace keiko {

/// Deviation of a surface from the form around a place.
struct DentDepth {
    double offset = 0;      ///< mm, positive outwards: of a bump
    double bound = 0;       ///< mm, an estimate
    SheetPoint at;          ///< where the deviation is largest
    Vec3 position{0};       ///< world, mm
    bool one_sided = false; ///< a border is so near that some quarter around has no form
    bool alone = false; ///< less than a quarter of the surroundings deviates half as much, unlike
                        ///< waves
};

/// Climbs from a place to the largest deviation of the surface from the form around it, which is
/// fitted in windows about `reach` mm to either side (docs/theory/inspection.md). The climb
/// crosses smooth seams and stays on one side of a border. nullopt if the surroundings are too
/// small.
std::optional<DentDepth> dent_depth(const FaceAdjacency& faces, const SheetPoint& begin,
                                    double reach);

} // namespace keiko
