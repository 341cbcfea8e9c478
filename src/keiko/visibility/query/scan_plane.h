#pragma once

#include "keiko/visibility/boundaries/boundary_piece.h"
#include "keiko/visibility/silhouettes/silhouette_piece.h"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A place as a viewpoint sees it: the slope along a row of segments and across it.
struct ScreenPlace {
    double along = 0, across = 0; ///< slopes; mm for parallel light
    double depth = 0;             ///< mm; 1 for parallel light
};

/// Bounds of a place on the screen.
struct ScanBounds {
    double along_low = std::numeric_limits<double>::infinity();   ///< least along
    double along_high = -std::numeric_limits<double>::infinity(); ///< largest along
    double across_low = along_low, across_high = along_high;      ///< least and largest across

    /// True if no place is within the bounds, as by default.
    bool empty() const { return !(across_low <= across_high && along_low <= along_high); }
    /// True if a place is within both, borders included.
    bool overlaps(const ScanBounds& other) const {
        return across_low <= other.across_high && across_high >= other.across_low &&
               along_low <= other.along_high && along_high >= other.along_low;
    }
};

/// Screen of a scan-line search [Nishita1985]: the viewpoint is the eye, parallel segments are the
/// scan lines, across = constant. Places are slopes x / z along and y / z across, z being the depth
/// towards the segments; parallel light projects along itself instead, in mm. Then planes through
/// the viewpoint and a segment are lines of the screen.
class ScanPlane {
public:
    /// `along`: unit direction of the segments; `middle`: a place among them.
    ScanPlane(const Viewpoint& viewpoint, const Vec3& along, const Vec3& middle);

    /// False where the segments are seen end-on, so that there are no scan lines.
    bool regular() const { return regular_; }
    /// Whether a segment of this direction is a scan line.
    bool is_along(const Vec3& direction) const;
    /// Place of a world point on the screen, infinite or undefined at depth 0.
    ScreenPlace place(const Vec3& x) const;
    /// Unit vector along the screen, world.
    const Vec3& along() const { return x_; }
    /// Unit vector across the screen, world.
    const Vec3& across() const { return y_; }
    /// From the viewpoint, at right angles to the segments.
    Vec3 way_at(double across) const { return z_ + y_ * across; }
    /// A box around places; nothing where one is not before the screen.
    std::optional<ScanBounds> hull(std::span<const Vec3> places) const;
    /// Bounds of the places where a piece may be edge-on; empty where it is not. `edge_on`: zero
    /// where it is.
    ScanBounds box(const SilhouettePiece& piece, const AffineBounds::Weighed& edge_on) const;
    /// Bounds of the places of all that is within the error of a border.
    ScanBounds box(const BoundaryPiece& border) const;

private:
    /// Weights that turn homogeneous coordinates relative to `center` into x, y or z.
    Vec4 weights(const Vec3& direction, const Vec3& center) const;
    Vec4 depth_weights(const Vec3& center) const;

    Vec3 origin_, along_, x_, y_, z_;
    bool parallel_, regular_;
};

/// Boxes of a screen in order of where they lie across its scan lines, to find those that one line
/// after the other meets.
class BucketGrid {
public:
    /// `low` to `high`: the places across that most queries are for.
    BucketGrid(std::vector<ScanBounds> boxes, double low, double high);

    /// Calls `visit` with the number of each box that meets a scan line between two places along
    /// it, rising.
    template <class Visit>
    void each_met(double across, double along_low, double along_high, const Visit& visit) const {
        const std::size_t bucket = bucket_of(across);
        for (std::uint32_t i = first_[bucket]; i < first_[bucket + 1]; ++i) {
            const ScanBounds& box = boxes_[members_[i]];
            if (box.across_low <= across && box.across_high >= across &&
                box.along_low <= along_high && box.along_high >= along_low)
                visit(members_[i]);
        }
    }

private:
    std::size_t bucket_of(double across) const {
        const double place = (across - low_) * per_width_;
        return place > 0 ? static_cast<std::size_t>(
                               std::min(place, static_cast<double>(first_.size() - 2)))
                         : 0;
    }

    std::vector<ScanBounds> boxes_;
    double low_, per_width_;
    std::vector<std::uint32_t> first_;   ///< of each bucket's members, and their number
    std::vector<std::uint32_t> members_; ///< numbers of boxes
};

} // namespace keiko
