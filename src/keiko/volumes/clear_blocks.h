#pragma once

#include "keiko/math/vec.h"

#include <array>
#include <cstddef>
#include <vector>

namespace keiko {

/// Blocks of cells of a grid, and which of them have no extinction at any node.
class ClearBlocks {
public:
    /// Blocks of a grid by the extinctions of its nodes, x fastest, then y.
    ClearBlocks(const std::array<int, 3>& nodes, const std::vector<float>& extinctions);

    /// Parameter at which the ray leaves the clear block that holds its point at t; t itself where
    /// that block is not clear. The point is in steps between nodes.
    double leaves(const Vec3& origin, const Vec3& direction, double t) const;

private:
    static constexpr int side = 8; ///< cells

    std::array<int, 3> count_{};
    std::vector<char> clear_; ///< by block, x fastest; 1: clear
};

} // namespace keiko
