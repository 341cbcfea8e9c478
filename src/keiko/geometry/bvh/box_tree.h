#pragma once

#include "keiko/math/bounds.h"

#include <cstdint>
#include <functional>
#include <vector>

namespace keiko {

/// A binary tree over boxes for queries by box and by distance from a point.
class BoxTree {
public:
    /// Empty and infinite boxes overlap nothing.
    explicit BoxTree(std::vector<Box3> boxes);

    /// Indices of the boxes that overlap `box`, ascending.
    std::vector<std::uint32_t> overlapping(const Box3& box) const;
    /// Calls `visit` with the boxes nearer to `p` than `radius` mm, the nearest first; it returns
    /// the radius for the following ones.
    void visit_near(const Vec3& p, double radius,
                    const std::function<double(std::uint32_t)>& visit) const;

private:
    struct Node {
        Box3 box;
        std::uint32_t first = 0, count = 0; ///< of order_; an inner node where right is not 0
        std::uint32_t right = 0;            ///< the left child follows its parent
    };
    std::uint32_t build(std::uint32_t first, std::uint32_t count);

    std::vector<Box3> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace keiko
