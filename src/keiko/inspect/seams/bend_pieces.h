#pragma once

#include "keiko/inspect/seams/knot_piece.h"

#include <vector>

namespace keiko {

/// The lines inside a face across which its normal turns within `window` mm, not placed, as
/// coincident or nearly coincident control points cause them: a piece for each patch along which
/// such a line runs. Candidates are the slow lines of its patches, tested at one place more than
/// the degree along them. A line's sides are a thousandth of the window apart if the face turns
/// between these by more than 1e-4 degrees, or has no normal on the line and breaks_at() it. They
/// are a window apart if the face turns by a hundredth more between those, by more than 1e-3
/// degrees, and at least as much as the curvatures beside it explain. No two pieces lie within each
/// other's sides.
std::vector<KnotPiece> bend_pieces(const KnottedFace& face, double window);

} // namespace keiko
