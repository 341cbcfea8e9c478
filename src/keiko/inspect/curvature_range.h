#pragma once

#include "keiko/math/interval.h"
#include "keiko/patch/bezier_patch.h"

namespace keiko {

/// Ranges that hold the curvatures at every place of a patch, 1/mm and 1/mm2, with respect to the
/// normal along du x dv: positive where the surface bends towards it.
struct CurvatureRange {
    Interval k1, k2; ///< the larger and the smaller principal curvature
    Interval mean, gaussian;
    /// By how much they may change along u and along v: which way a cut sharpens them more.
    double spread_u = 0, spread_v = 0;

    bool finite() const;
    /// The same surface seen from its other side.
    CurvatureRange turned() const;
};

/// From Taylor polynomials of the second order about the patch's centre with interval remainders,
/// in a frame that lies along its principal directions there, so that the excess shrinks with the
/// cube of the patch's size (docs/theory/inspection.md). Infinite where the parametrisation may be
/// singular. `rounding`: how far, in mm, each coordinate of a control point may be off beside what
/// computing with numbers as large as the patch rounds off; it is best given near the origin.
CurvatureRange curvature_range(const BezierPatchView& patch, double rounding = 0);

} // namespace keiko
