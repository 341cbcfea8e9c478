#pragma once

#include "keiko/inspect/check.h"
#include "keiko/inspect/seams/model_borders.h"

#include <span>
#include <vector>

namespace keiko {

/// Findings worth a look at borders of faces, as checks of the placed faces. They are narrow
/// strips beside creases, openings between free edges, missing caps, free edges on other faces, and
/// bodies that cross.
/// `pieces`: those of the seams, MeasuredSeams::pieces; `join` in mm.
std::vector<Check> looks_at_borders(const ModelBorders& borders,
                                    std::span<const MeasuredSeam> seams,
                                    std::span<const Seam> pieces, const CriteriaPreset& preset,
                                    double join, const Job& job = {});

} // namespace keiko
