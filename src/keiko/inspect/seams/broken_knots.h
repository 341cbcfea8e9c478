#pragma once

#include "keiko/inspect/seams/knot_piece.h"

#include <vector>

namespace keiko {

/// The sides of a face's patches along which it breaks (breaks_at), regardless of its trims, and
/// those at which it is torn: open by more than 1e-4 mm.
struct BrokenKnots {
    std::vector<KnotPiece> pieces, torn;
};

/// Broken sides of a face. Each side is tested at 4 n places, n the degree along it. The tangents
/// on either side and the one along it span a volume of degree 4 n - 1: no kink is 0 at all of the
/// places and not in between. A break of the curvatures alone may be missed.
BrokenKnots broken_knots(const KnottedFace& face);

} // namespace keiko
