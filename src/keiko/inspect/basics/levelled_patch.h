#pragma once

#include "keiko/geometry/bezier/bezier.h"

#include <vector>

namespace keiko {

/// A patch moved to its centre, turned so that its tangents there lie in the plane z = 0, with
/// parameters that run uniformly. Its derivatives then depend on its curvature alone, not on its
/// position in space or its parametrisation (docs/theory/inspection.md).
class LevelledPatch {
public:
    /// `rounding`: error of each coordinate of a control point, mm.
    LevelledPatch(const BezierPatchView& patch, double rounding);

    BezierPatchView view() const { return {degree_u_, degree_v_, points_}; }
    /// Error of each coordinate of its own control points, including the rounding of levelling, mm.
    double rounding() const { return rounding_; }

private:
    int degree_u_, degree_v_;
    std::vector<Vec4> points_;
    double rounding_ = 0;
};

} // namespace keiko
