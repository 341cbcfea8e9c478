#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/rays/visibility.h"

#include <array>
#include <vector>

namespace KEIKO_API keiko {

/// Densities on the nodes of a grid that fills a box, trilinear between them, 0 outside
/// (docs/theory/fog.md#grids).
class VoxelDensity {
public:
    /// Density with the first and the last nodes at the corners `low` and `high`, mm. Requires at
    /// least two nodes along each axis, low below high, and as many values as nodes, x fastest,
    /// then y.
    VoxelDensity(const Vec3& low, const Vec3& high, const std::array<int, 3>& nodes,
                 std::vector<double> values);

    /// Density at a point; 0 outside of the box.
    double operator()(const Vec3& point) const;
    /// Parameters of the segment, rising, at which it crosses planes of nodes inside the box and
    /// the faces of the box.
    std::vector<double> crossings(const Segment& segment) const;
    /// Mean density along the segment; exact up to rounding, because the density is cubic along
    /// the part in one cell.
    double mean_along(const Segment& segment) const;

private:
    Vec3 low_, high_;
    std::array<int, 3> nodes_;
    std::vector<double> values_;
};

} // namespace keiko
