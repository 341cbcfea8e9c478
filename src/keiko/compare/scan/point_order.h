#pragma once

#include "keiko/math/vec.h"

#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

/// Indices of points in an order in which most follow a near one: along the Z-order curve
/// of their box.
std::vector<std::uint32_t> neighbour_order(std::span<const Vec3> points);

/// About how far points that lie on a surface are from each other, mm: by the cells of a grid that
/// they fill. 0 for fewer than two places.
double point_spacing(std::span<const Vec3> points);

/// Points in cells, by place. Refers to the points.
class PointGrid {
public:
    /// Cells of `radius` > 0 mm, which is also how far near_points() looks.
    PointGrid(std::span<const Vec3> points, double radius);

    /// Indices of the points within the radius of a place, in a fixed order.
    std::vector<std::uint32_t> near_points(const Vec3& place) const;
    /// Number of cells that hold points.
    std::size_t cell_count() const { return cells_.size(); }

private:
    /// The points of a cell follow each other in the order.
    struct Cell {
        std::uint64_t key = 0;
        std::uint32_t first = 0, end = 0;
    };
    std::uint64_t key_of(const Vec3& place, int dx, int dy, int dz) const;

    std::span<const Vec3> points_;
    Vec3 lower_{0};
    double radius_;
    std::vector<std::uint32_t> order_;
    std::vector<Cell> cells_; ///< by rising keys
};

} // namespace keiko
