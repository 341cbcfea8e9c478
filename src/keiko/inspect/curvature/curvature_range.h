#pragma once

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/math/interval.h"

namespace keiko {

/// A range that holds a curvature at every place of a patch, and the places, in the patch's
/// parameters, where it probably comes near its ends.
struct Spread {
    Interval range;    ///< 1/mm, or 1/mm2 of the Gaussian curvature; infinite if unknown
    Vec2 lowest{0.5};  ///< where the curvature is probably least
    Vec2 highest{0.5}; ///< where the curvature is probably largest

    /// The spread of the negative curvature.
    Spread turned() const { return {-range, highest, lowest}; }
};

/// The curvatures of a patch, 1/mm and 1/mm2, with respect to the normal along du x dv: positive
/// where the surface bends towards it.
struct CurvatureRange {
    Spread k1, k2;   ///< the larger and the smaller principal curvature
    Spread mean;     ///< half of k1 + k2
    Spread gaussian; ///< k1 k2, 1/mm2
    /// Bending of the surface along u and along v; a cut across the larger one sharpens the ranges
    /// more.
    double bend_u = 0, bend_v = 0;

    /// True if both ends of all four ranges are finite.
    bool finite() const;
    /// The curvatures with respect to the opposite normal.
    CurvatureRange turned() const;
};

/// Ranges from Taylor models about the patch's centre, in a frame along its principal directions
/// there, so that the excess shrinks with the cube of the patch's size (docs/theory/inspection.md).
/// They are infinite where the parametrisation may be singular. `rounding`: error of each
/// coordinate of a control point, mm, beside the rounding of computing with numbers as large as the
/// patch; it is best given near the origin.
CurvatureRange curvature_range(const BezierPatchView& patch, double rounding = 0);

} // namespace keiko
