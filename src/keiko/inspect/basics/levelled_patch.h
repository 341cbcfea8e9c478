#pragma once

#include "keiko/geometry/bezier/bezier_patch.h"

#include <vector>

namespace keiko {

/// A patch moved to its centre, turned so that its tangents there lie in the plane z = 0, and given
/// parameters that run evenly: its derivatives then tell of its bend alone, not of how it lies in
/// space or is run through (docs/theory/inspection.md).
class LevelledPatch {
public:
    /// `rounding`: how far each coordinate of a control point may be off, mm.
    LevelledPatch(const BezierPatchView& patch, double rounding);

    BezierPatchView view() const { return {degree_u_, degree_v_, points_}; }
    /// The same of its own control points, with what levelling rounds off, mm.
    double rounding() const { return rounding_; }

private:
    int degree_u_, degree_v_;
    std::vector<Vec4> points_;
    double rounding_ = 0;
};

} // namespace keiko
