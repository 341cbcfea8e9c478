#pragma once

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/math/jet.h"
#include "keiko/math/taylor_model.h"

#include <vector>

namespace keiko {

/// A patch moved to its centre, turned so that its tangents there lie in the plane z = 0, with
/// parameters that run uniformly. Its derivatives then depend on its curvature alone, not on its
/// position in space or its parametrisation (docs/theory/inspection.md).
class LevelledPatch {
public:
    /// `rounding`: error of each coordinate of a control point, mm.
    LevelledPatch(const BezierPatchView& patch, double rounding);

    /// View of its own control points, which it must outlive.
    BezierPatchView view() const { return {degree_u_, degree_v_, points_}; }
    /// Error of each coordinate of its own control points, including the rounding of levelling, mm.
    double rounding() const { return rounding_; }

private:
    int degree_u_, degree_v_;
    std::vector<Vec4> points_;
    double rounding_ = 0;
};

/// Point and weight, or a derivative of both, over a patch: S = p / w.
struct HomogeneousModel {
    Triple<TaylorModel> p; ///< w times the point, mm, or a derivative of that product
    TaylorModel w;         ///< weight, or a derivative of it
};

/// A patch and its derivatives to the second order as Taylor models: x = 2 u - 1, y = 2 v - 1, the
/// derivatives by x and y. The weight of one that is not rational is 1.
struct PatchModel {
    HomogeneousModel s;  ///< the patch
    HomogeneousModel x;  ///< derivative by x
    HomogeneousModel y;  ///< derivative by y
    HomogeneousModel xx; ///< second derivative by x
    HomogeneousModel xy; ///< mixed derivative
    HomogeneousModel yy; ///< second derivative by y
};

/// Taylor models from the derivatives at the centre, and from the convex hulls of the control
/// points of the higher ones. `rounding`: error of each homogeneous coordinate of a control point,
/// mm.
PatchModel patch_model(const BezierPatchView& patch, double rounding);

} // namespace keiko
