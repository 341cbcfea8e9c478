#pragma once

#include "keiko/inspect/flaws/face_adjacency.h"

#include <optional>

namespace keiko {

/// How far a surface lies off the form around a place.
struct DentDepth {
    double offset = 0; ///< mm, positive outwards: of a bump
    double bound = 0;  ///< mm, an estimate, as DentForm's
    SheetPoint at;
    Vec3 position{0};       ///< world, mm
    bool one_sided = false; ///< a border is so near that there is no form in some quarter around
    bool alone = false; ///< less than a quarter of what is around is half as far off, as of waves
};

/// Climbs from a place to where the surface is furthest off the form around it, as
/// dent_form has it for windows about `reach` mm to either side (docs/theory/inspection.md); over
/// smooth seams, on one side of a border. Nothing where too little is around.
std::optional<DentDepth> dent_depth(const FaceAdjacency& faces, const SheetPoint& begin,
                                    double reach);

} // namespace keiko
