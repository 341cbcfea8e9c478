#pragma once

#include "keiko/visibility/boundaries/border_piece.h"
#include "keiko/visibility/silhouettes/silhouette_events.h"

#include <array>
#include <vector>

namespace keiko {

/// A stretch of the outline that an apex sees of a patch: the line along which it is seen edge-on,
/// as a curve of degree 5 through exact places of it, like a border.
struct OutlinePiece {
    /// `inward`: to the side of the outline on which the apex sees the patch. `error`: mm.
    BorderPiece line;
    std::uint32_t patch = 0; ///< into Silhouettes::patches
    bool trimmed = false;    ///< trim curves may cross it
    /// Control points of its place on that patch.
    std::array<Vec2, BorderPiece::points> places{Vec2(0), Vec2(0), Vec2(0),
                                                 Vec2(0), Vec2(0), Vec2(0)};

    Vec2 place_at(double t) const;
};

/// How far a line may be from the outline: rad, as the apex sees it.
constexpr double outline_error = 1e-7;

/// Appends the outline of a candidate, which overlaps those of its neighbours a little, where it is
/// proved to run across the piece as a graph of one of its parameters, and curves meet it to within
/// outline_error. False, with nothing appended, elsewhere: cusps, poles, and pieces that an outline
/// bends in.
bool append_outline(const Silhouettes& silhouettes, const LeafKernels& kernels,
                    const SilhouetteCandidate& candidate, const Apex& apex,
                    std::vector<OutlinePiece>& outlines);

} // namespace keiko
