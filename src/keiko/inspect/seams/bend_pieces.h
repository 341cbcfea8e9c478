#pragma once

#include "keiko/inspect/seams/knot_piece.h"

#include <vector>

namespace keiko {

/// The lines inside a face across which its normal turns within `window` mm, not placed, as
/// coincident or nearly coincident control points make them: a piece for each patch that such a
/// line runs along. Candidates are the slow lines of its patches, tested at a place more than the
/// degree along them. The sides of one are a thousandth of the window apart, where the face turns
/// between these by more than 1e-4 degrees or has no normal on the line and breaks_at() it. They
/// are a window apart where the face turns by a hundredth more between those, by more than 1e-3
/// degrees, and no less than the curvatures beside it explain. No two pieces lie within each
/// other's sides.
std::vector<KnotPiece> bend_pieces(const KnottedFace& face, double window);

} // namespace keiko
