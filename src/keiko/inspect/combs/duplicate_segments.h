#pragma once

#include "keiko/inspect/combs/comb_curves.h"

#include <vector>

namespace keiko {

/// Pieces along borders without what an earlier such piece has already, within `near` mm of it: a
/// border belongs to the faces on both of its sides.
std::vector<CombPiece> without_doubles(std::vector<CombPiece> pieces, double near);

} // namespace keiko
