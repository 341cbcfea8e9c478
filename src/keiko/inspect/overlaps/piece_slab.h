#pragma once

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/math/interval_set.h"

#include <optional>

namespace keiko {

/// Bounds of the points within a distance of a piece of surface: its box, and, if it has a mean
/// normal, two planes square to that.
class PieceSlab {
public:
    /// `reach` in mm.
    PieceSlab(const BezierPatchView& piece, double reach);

    /// mm: the diagonal of the piece's box.
    double size() const { return size_; }
    /// mm between the planes that hold the piece; its size if it has no mean normal.
    double thickness() const { return thickness_; }
    /// The axis along which the piece is longer, 0 or 1.
    unsigned longer_side() const { return longer_side_; }
    /// The part of a segment, from 0 to 1, that is within the slab; nullopt if there is none.
    std::optional<ParameterInterval> clip(const Vec3& from, const Vec3& to) const;

private:
    Box3 box_;
    Vec3 normal_{0};
    double low_ = 0, high_ = 0; ///< along the normal
    double size_ = 0, thickness_ = 0;
    unsigned longer_side_ = 0;
};

} // namespace keiko
