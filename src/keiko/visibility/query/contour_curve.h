#pragma once

#include "keiko/visibility/boundaries/boundary_piece.h"
#include "keiko/visibility/silhouettes/silhouette_events.h"

#include <array>
#include <vector>

namespace keiko {

/// A stretch of the outline that a viewpoint sees of a patch: the line along which it is seen
/// edge-on, as a curve of degree 5 through exact places of it, like a border.
struct ContourCurve {
    /// `inward`: to the side of the outline on which the viewpoint sees the patch. `error`: mm.
    BoundaryPiece line;
    std::uint32_t patch = 0; ///< into Silhouettes::patches
    bool trimmed = false;    ///< trim curves may cross it
    /// Control points of its place on that patch.
    std::array<Vec2, BoundaryPiece::points> places{Vec2(0), Vec2(0), Vec2(0),
                                                   Vec2(0), Vec2(0), Vec2(0)};

    /// Place on the patch at parameter t of the line.
    Vec2 place_at(double t) const;
};

/// How far a line may be from the outline: rad, as the viewpoint sees it.
constexpr double outline_error = 1e-7;

/// Appends the outline of a candidate, which overlaps those of its neighbours a little. It must be
/// proved to run across the piece as a graph of one of its parameters, and curves meet it to within
/// outline_error. False, with nothing appended, elsewhere: cusps, poles, and pieces that an outline
/// bends in.
bool append_contour(const Silhouettes& silhouettes, const SubPatchKernels& kernels,
                    const SilhouetteCandidate& candidate, const Viewpoint& viewpoint,
                    std::vector<ContourCurve>& outlines);

} // namespace keiko
