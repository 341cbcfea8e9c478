#pragma once

#include "keiko/inspect/knot_piece.h"

#include <vector>

namespace keiko {

/// The lines inside a face across which its normal turns within `window` mm, as coincident or
/// nearly coincident control points make them: a piece for each patch that such a line runs along.
/// Candidates are the slow lines of its patches. Their sides are evaluated a thousandth of the
/// window apart, and where nothing breaks there by more than 1e-4 degrees, or 0.1 % of the
/// curvatures, a window apart: they bend by more than 1e-3 degrees. No two lie within each other's
/// sides.
std::vector<KnotPiece> bend_pieces(const KnottedFace& face, double window);

} // namespace keiko
