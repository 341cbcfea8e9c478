#pragma once

#include "keiko/math/bounds.h"
#include "keiko/math/vec.h"

#include <cstdint>
#include <functional>
#include <span>
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
    /// Calls `visit` with the boxes for which `meets`(box) is true. It must then be true for every
    /// box around these. Ends with true once `visit` returns true.
    template <class Meets, class Visit>
    bool any_of(const Meets& meets, const Visit& visit) const {
        std::vector<std::uint32_t> todo;
        if (!nodes_.empty()) todo.push_back(0);
        while (!todo.empty()) {
            const std::uint32_t index = todo.back();
            const Node& node = nodes_[index];
            todo.pop_back();
            if (!meets(node.box)) continue;
            if (node.right != 0) {
                todo.insert(todo.end(), {node.right, index + 1});
                continue;
            }
            for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
                if (meets(boxes_[order_[k]]) && visit(order_[k])) return true;
        }
        return false;
    }

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

/// Boxes in a tree that finds those which a plane cuts.
class PlaneTree {
public:
    /// The boxes must be finite, and none empty.
    explicit PlaneTree(std::vector<Box3> boxes);

    /// The numbers of the boxes that the plane normal.x = offset cuts, rising.
    std::vector<std::uint32_t> cut_by(const Vec3& normal, double offset) const;

private:
    /// A box by its middle and half its edges.
    struct Block {
        Vec3 middle{0}, half{0};

        bool cut_by(const Vec3& normal, double offset) const;
    };
    /// Node in the order of traversal: the first child comes next, `skip` is the node after this
    /// node's children.
    struct Node {
        Block block;
        std::uint32_t first = 0, count = 0; ///< into order_, of a leaf
        std::uint32_t skip = 0;
    };

    void build(std::span<std::uint32_t> part, std::span<const Box3> boxes);

    std::vector<Block> blocks_; ///< of the boxes, in `order_`
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace keiko
