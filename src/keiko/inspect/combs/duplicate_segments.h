#pragma once

#include "keiko/inspect/combs/comb_curves.h"

#include <vector>

namespace keiko {

/// Pieces along borders without the parts that an earlier piece covers within `near` mm. A border
/// belongs to the faces on both of its sides.
std::vector<CombPiece> without_doubles(std::vector<CombPiece> pieces, double near);

} // namespace keiko
