#pragma once

#include "keiko/inspect/check.h"
#include "keiko/inspect/seams/model_borders.h"

#include <span>
#include <vector>

namespace keiko {

/// What deserves a look at the borders of a model's faces, as checks of its placed faces: narrow
/// strips beside creases, openings between free edges, missing caps, and free edges on other faces.
/// `pieces`: those of the seams, MeasuredSeams::pieces; `join` in mm.
std::vector<Check> looks_at_borders(const ModelBorders& borders,
                                    std::span<const MeasuredSeam> seams,
                                    std::span<const Seam> pieces, const CriteriaPreset& preset,
                                    double join, const Job& job = {});

} // namespace keiko
