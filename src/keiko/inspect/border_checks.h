#pragma once

#include "keiko/inspect/check.h"
#include "keiko/inspect/seams/model_borders.h"

#include <span>
#include <vector>

namespace keiko {

/// Checks at borders of faces, of the placed faces. A strip that is a kink fails, and so does an
/// edge that faces share while their borders are apart. Worth a look are narrow strips beside
/// creases, openings between free edges, missing caps, free edges on other faces, and bodies that
/// cross. A check is of the first of its faces that is in the scope, and is left out without any.
/// `pieces`: those of the seams, MeasuredSeams::pieces; `join` in mm.
std::vector<Check> checks_at_borders(const ModelBorders& borders,
                                     std::span<const MeasuredSeam> seams,
                                     std::span<const Seam> pieces, const FaceLimits& limits,
                                     double join, const Job& job = {});

} // namespace keiko
