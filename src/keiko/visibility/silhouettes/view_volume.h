#pragma once

#include "keiko/geometry/rays/ray.h"
#include "keiko/math/bounds.h"
#include "keiko/visibility/boundaries/boundary_piece.h"
#include "keiko/visibility/silhouettes/silhouette_piece.h"

#include <array>
#include <cstdint>
#include <span>

namespace keiko {

/// The pyramid between a viewpoint and all that it may be asked about (a prism for parallel light):
/// what lies outside hides nothing of it.
class ViewVolume {
public:
    /// `region` holds corners of a convex body around every segment to come.
    /// With `facing` only what lies on its side of the plane through the viewpoint hides anything;
    /// the viewpoint is then a point, not at infinity.
    ViewVolume(const Viewpoint& viewpoint, std::span<const Vec3> region,
               const std::optional<Vec3>& facing = {});

    /// The hull of places and a region: what lies outside is between none of the two. With `facing`
    /// only what lies on its side of all places, beyond rounding.
    ViewVolume(std::span<const Vec3> places, std::span<const Vec3> region,
               const std::optional<Vec3>& facing = {});

    /// Sides of the volume, a bit each: those that something may lie across or beyond.
    using Sides = std::uint32_t;
    /// Set of all sides, 7 at most.
    Sides all_sides() const { return (Sides{1} << count_) - 1; }

    /// False when the box is proved to lie beyond one of `sides`. Removes the sides that
    /// hold all of it: no part of it need be compared with them.
    bool may_hold(const Box3& box, Sides& sides) const;
    /// False when a piece is proved to lie beyond a side, by its parallelogram or control points,
    /// tighter than its box.
    bool may_hold(const SilhouettePiece& piece, Sides& sides) const;
    /// False when a border with all within its error is proved to lie beyond a side.
    bool may_hold(const BoundaryPiece& border, Sides& sides) const;
    /// False when a curve of degree 5, relative to `center`, is proved to lie beyond a side with
    /// all within `error` of it.
    bool may_hold(const BoundaryPiece::Curve& curve, const Vec3& center, double error,
                  Sides& sides) const;
    /// False when bounded points in the axes of a frame are proved to lie beyond a side.
    bool may_hold(const AffineBounds& points, const NetFrame& frame, Sides& sides) const;
    /// World box of the region itself.
    const Box3& region() const { return region_; }

private:
    /// The side where normal.x >= offset.
    struct HalfSpace {
        Vec3 normal{0}, size{0};       ///< `size`: magnitudes of the normal's components
        double offset = 0, length = 1; ///< of the normal
    };
    void add(const Vec3& normal, double offset);
    /// How far something lies inside of a side.
    struct Depth {
        double least, most;
    };
    /// By `depth` of a half-space.
    template <class DepthIn>
    bool may_hold(Sides& sides, const DepthIn& depth) const {
        for (std::size_t i = 0; i < count_; ++i) {
            const Sides side = Sides{1} << i;
            if ((sides & side) == 0) continue;
            const Depth in = depth(half_spaces_[i]);
            if (in.most < 0) return false;
            if (in.least >= 0) sides &= ~side;
        }
        return true;
    }

    Box3 region_, hull_;
    std::array<HalfSpace, 7> half_spaces_;
    std::size_t count_ = 0;
};

} // namespace keiko
