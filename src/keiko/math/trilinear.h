#pragma once

#include "keiko/math/vec.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace keiko {

/// Cell of a grid of nodes that holds a place.
struct GridCell {
    std::array<std::size_t, 3> node{}; ///< the first of its eight, along x, y and z
    Vec3 t{0};                         ///< place in the cell, 0 to 1 along each axis
};

/// Cell of a place inside a grid, in steps between nodes from the first; `nodes` along each axis,
/// at least two. A place on the last nodes lies in the last cell.
inline GridCell grid_cell(const Vec3& place, const std::array<int, 3>& nodes) {
    GridCell cell;
    for (unsigned axis = 0; axis < 3; ++axis) {
        const int node = std::clamp(static_cast<int>(place[axis]), 0, nodes[axis] - 2);
        cell.node[axis] = static_cast<std::size_t>(node);
        cell.t[axis] = place[axis] - node;
    }
    return cell;
}

/// Trilinear interpolation in a cell at `t`. `at` returns the value of the node that is 0 or 1
/// steps along x, y and z from the first.
template <class At>
auto trilinear(const Vec3& t, const At& at) {
    using Steps = std::size_t;
    const auto along_x = [&](Steps y, Steps z) {
        const auto first = at(Steps(0), y, z);
        return first + (at(Steps(1), y, z) - first) * t.x;
    };
    const auto along_y = [&](Steps z) {
        const auto first = along_x(0, z);
        return first + (along_x(1, z) - first) * t.y;
    };
    const auto first = along_y(0);
    return first + (along_y(1) - first) * t.z;
}

} // namespace keiko
