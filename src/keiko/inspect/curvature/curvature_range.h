#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"
#include "keiko/math/interval.h"

namespace keiko {

/// A range that holds a curvature at every place of a patch, and the places, by the patch's
/// parameters, where it is likely to come near its ends.
struct Spread {
    Interval range;
    Vec2 lowest{0.5}, highest{0.5};

    Spread turned() const { return {-range, highest, lowest}; }
};

/// The curvatures of a patch, 1/mm and 1/mm2, with respect to the normal along du x dv: positive
/// where the surface bends towards it.
struct CurvatureRange {
    Spread k1, k2; ///< the larger and the smaller principal curvature
    Spread mean, gaussian;
    /// By how much the surface bends along u and along v: which way a cut sharpens them more.
    double bend_u = 0, bend_v = 0;

    bool finite() const;
    /// The same surface seen from its other side.
    CurvatureRange turned() const;
};

/// From Taylor models about the patch's centre, in a frame that lies along its principal directions
/// there, so that the excess shrinks with the cube of the patch's size (docs/theory/inspection.md).
/// Infinite where the parametrisation may be singular. `rounding`: how far, in mm, each coordinate
/// of a control point may be off beside what computing with numbers as large as the patch rounds
/// off; it is best given near the origin.
CurvatureRange curvature_range(const BezierPatchView& patch, double rounding = 0);

} // namespace keiko
