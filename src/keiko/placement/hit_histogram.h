#pragma once

#include "keiko/base/export.h"
#include "keiko/math/bounds.h"

#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// A place on a plane and its weight.
struct WeightedPlace {
    Vec2 place{0};     ///< mm, in the plane's coordinates
    double weight = 0; ///< share of the picture
};

/// Distribution of the picture's reflections over a plane: weights on a grid of cells.
class HitHistogram {
public:
    HitHistogram() = default;
    /// `cells` x `cells` over the weighted quantiles of the places (0.5 to 99.5 % of each
    /// coordinate, a tenth wider), or over `range`.
    HitHistogram(std::span<const WeightedPlace> places, int cells);
    /// Histogram of `cells` x `cells` over a given range.
    HitHistogram(std::span<const WeightedPlace> places, int cells, const Box2& range);

    /// The part of the plane that the grid covers, mm.
    const Box2& range() const { return range_; }
    /// Number of columns.
    int width() const { return cells_; }
    /// Number of rows.
    int height() const { return cells_; }
    /// Weight in the cell of column `u` and row `v`.
    double at(int u, int v) const { return weights_[index(u, v)]; }
    /// Total weight of all places, including those beside the range.
    double total() const { return total_; }
    /// Each cell the 1-2-1 tent mean of its neighbourhood: for pictures.
    HitHistogram smoothed() const;

    /// A small rectangle for each share of the total (falling, 0 to 1), which holds that share. It
    /// is found by removing the border row or column of least weight per area as long as enough
    /// remains. A share that the range does not hold gives the whole range.
    std::vector<Box2> rectangles(std::span<const double> shares) const;

private:
    std::size_t index(int u, int v) const {
        return static_cast<std::size_t>(v) * static_cast<std::size_t>(cells_) +
               static_cast<std::size_t>(u);
    }

    Box2 range_;
    int cells_ = 0;
    std::vector<double> weights_;
    double total_ = 0;
};

} // namespace keiko
