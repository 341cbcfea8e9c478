#pragma once

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/math/jet.h"
#include "keiko/math/taylor_model.h"

namespace keiko {

/// Point and weight, or a derivative of both, over a patch: S = p / w.
struct HomogeneousModel {
    Triple<TaylorModel> p;
    TaylorModel w;
};

/// A patch and its derivatives to the second order as Taylor models: x = 2 u - 1, y = 2 v - 1, the
/// derivatives by x and y. The weight of one that is not rational is 1.
struct PatchModel {
    HomogeneousModel s, x, y, xx, xy, yy;
};

/// Taylor models from the derivatives at the centre, and from the convex hulls of the control
/// points of the higher ones. `rounding`: error of each homogeneous coordinate of a control point,
/// mm.
PatchModel patch_model(const BezierPatchView& patch, double rounding);

} // namespace keiko
