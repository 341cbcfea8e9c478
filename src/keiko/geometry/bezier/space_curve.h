#pragma once

#include "keiko/math/vec.h"

#include <vector>

namespace keiko {

/// Length of a curve between two bounds that are proved.
struct LengthRange {
    double least = 0; ///< mm, of chords
    double most = 0;  ///< mm, of control polygons

    /// Middle of the range, mm.
    double middle() const { return (least + most) / 2; }
    /// Half of the range, mm.
    double bound() const { return (most - least) / 2; }
};

/// Homogeneous control points of a rational Bezier curve whose weights are positive; at least one.
using CurvePoints = std::vector<Vec4>;

/// Length of the chord from end to end, mm: no curve between the ends is shorter.
double chord_length(const CurvePoints& curve);

/// Length of a curve. It is at least that of its chords and at most that of its control polygons.
/// Both are those of pieces, halved until the range is within 1e-6 of the length, or ten times.
LengthRange curve_length(const CurvePoints& curve);

/// Point at the curve's parameter 1/2.
Vec3 curve_middle(const CurvePoints& curve);

} // namespace keiko
