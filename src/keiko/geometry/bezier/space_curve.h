#pragma once

#include "keiko/math/vec.h"

#include <array>
#include <vector>

namespace keiko {

/// Both halves of a Bezier curve of at least one control point (de Casteljau).
template <class P>
std::array<std::vector<P>, 2> bezier_halves(std::vector<P> points) {
    const std::size_t degree = points.size() - 1;
    std::array<std::vector<P>, 2> halves{points, points};
    for (std::size_t level = 1; level <= degree; ++level) {
        for (std::size_t i = 0; i + level <= degree; ++i)
            points[i] = (points[i] + points[i + 1]) * 0.5;
        halves[0][level] = points.front();
        halves[1][degree - level] = points[degree - level];
    }
    return halves;
}

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
