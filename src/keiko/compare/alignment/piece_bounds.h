#pragma once

#include "keiko/intersect/subpatch/sub_patch_frame.h"

#include <array>

namespace keiko {

/// Bounds of a piece of surface in the frame of its mean tangents, for the search of nearest
/// points.
///
/// Between two points of the piece whose parameters differ by d, the chord is at least a |d| long.
/// Along any vector it deviates from the tangent by at most b |d|^2 / 2. Let q be a critical point
/// of the distance to p, and b be that along p - q. Every other point s of the piece has
/// |p - s|^2 >= |p - q|^2 + (a^2 - b) |d|^2. If b <= a^2, q is nearest.
class PieceBounds {
public:
    /// Proves nothing.
    PieceBounds() = default;
    /// Bounds of the piece that a frame was made of; those of an irregular frame prove nothing.
    explicit PieceBounds(const SubPatchFrame& frame);

    /// mm: no point of the piece is nearer to p than this, to rounding.
    double nearest(const Vec3& p) const;
    /// Whether a critical point of the distance to the piece, or to a part of it, is proved nearest
    /// there. `off`: the way from it to the place.
    bool proves(const Vec3& off) const;

private:
    Vec3 center_{0};
    std::array<Vec3, 3> across_{Vec3(0), Vec3(0), Vec3(0)}; ///< unit normals of three slabs
    std::array<double, 3> half_{};                          ///< mm, half the width of each
    std::array<Vec3, 3> axes_{Vec3(0), Vec3(0), Vec3(0)}; ///< S = centre + the sum of axes times X
    double first_ = 0;                                    ///< a, or less
    std::array<double, 3> second_{};                      ///< largest |X'' v v| of each axis
};

} // namespace keiko
