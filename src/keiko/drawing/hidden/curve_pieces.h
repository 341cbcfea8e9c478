#pragma once

#include "keiko/drawing/hidden/count_changes.h"
#include "keiko/drawing/hidden/sight_test.h"

#include <span>
#include <vector>

namespace keiko {

/// A piece of a curve that is visible or hidden as a whole.
struct CurvePiece {
    double begin = 0, end = 0; ///< parameters of the curve
    bool visible = true;       ///< nothing lies before it
    bool contour = false;      ///< as ModelCurve::is_contour_edge() in its middle

    bool operator==(const CurvePiece&) const = default;
};

/// The pieces of a curve in turn, from its begin to its end, in one view. Between neighbouring
/// changes a ray in the middle decides; rays at the points of the curve find changes that are not
/// given. `changes`: those that are known, by rising parameter.
std::vector<CurvePiece> pieces_by_rays(const ModelCurve& curve,
                                       std::span<const CountChange> changes,
                                       const SightTest& sight);

/// A piece of a curve before which lies one number of sheets.
struct CountedPiece {
    double begin = 0, end = 0; ///< parameters of the curve
    int sheets = 0;            ///< between it and the eye
};

/// The pieces of a curve between its changes by Appel's quantitative invisibility [Appel1967]. One
/// ray counts the sheets before the middle of the longest piece, and the changes are added from
/// there. It needs a view in which no two edges coincide, and is the second implementation of
/// pieces_by_rays: a piece is visible where it counts none.
std::vector<CountedPiece> pieces_by_count(const ModelCurve& curve,
                                          std::span<const CountChange> changes,
                                          const SightTest& sight);

} // namespace keiko
