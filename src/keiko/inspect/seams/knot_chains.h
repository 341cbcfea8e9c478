#pragma once

#include "keiko/inspect/seams/knot_piece.h"

#include <vector>

namespace keiko {

/// The lines that remain of pieces within the trims of a face: every stretch in the material,
/// however short, cut where the trim curves cross the piece. Both sides of a bend are in the
/// material. Stretches that touch on one line follow each other in a chain.
std::vector<std::vector<KnotPiece>> knot_chains(const SurfaceModel& model, const Face& face,
                                                const std::vector<KnotPiece>& pieces);

} // namespace keiko
