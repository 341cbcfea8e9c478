#include "keiko/geometry/bvh/plane_tree.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace keiko {

bool PlaneTree::Block::cut_by(const Vec3& normal, double offset) const {
    const double reach =
        std::abs(normal.x) * half.x + std::abs(normal.y) * half.y + std::abs(normal.z) * half.z;
    return std::abs(normal.dot(middle) - offset) <= reach;
}

PlaneTree::PlaneTree(std::vector<Box3> boxes) : order_(boxes.size()) {
    std::iota(order_.begin(), order_.end(), 0U);
    if (!order_.empty()) build(order_, boxes);
    blocks_.reserve(order_.size());
    for (const std::uint32_t box : order_)
        blocks_.push_back({boxes[box].center(), boxes[box].extent() * 0.5});
}

void PlaneTree::build(std::span<std::uint32_t> part, std::span<const Box3> boxes) {
    constexpr std::size_t most_in_leaf = 4;
    Box3 around, middles;
    for (const std::uint32_t box : part) {
        around.extend(boxes[box].lower);
        around.extend(boxes[box].upper);
        middles.extend(boxes[box].center());
    }
    const std::size_t self = nodes_.size();
    nodes_.push_back({.block = {around.center(), around.extent() * 0.5}});
    if (part.size() <= most_in_leaf) {
        nodes_[self].first = static_cast<std::uint32_t>(part.data() - order_.data());
        nodes_[self].count = static_cast<std::uint32_t>(part.size());
    } else {
        const Vec3 size = middles.extent();
        const unsigned axis = size.x >= std::max(size.y, size.z) ? 0U : size.y >= size.z ? 1U : 2U;
        const auto half = part.begin() + static_cast<std::ptrdiff_t>(part.size() / 2);
        std::nth_element(part.begin(), half, part.end(), [&](std::uint32_t a, std::uint32_t b) {
            return boxes[a].center()[axis] < boxes[b].center()[axis];
        });
        build({part.begin(), half}, boxes);
        build({half, part.end()}, boxes);
    }
    nodes_[self].skip = static_cast<std::uint32_t>(nodes_.size());
}

std::vector<std::uint32_t> PlaneTree::cut_by(const Vec3& normal, double offset) const {
    std::vector<std::uint32_t> found;
    for (std::size_t at = 0; at < nodes_.size();) {
        const Node& node = nodes_[at];
        if (!node.block.cut_by(normal, offset)) {
            at = node.skip;
            continue;
        }
        for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
            if (blocks_[i].cut_by(normal, offset)) found.push_back(order_[i]);
        ++at;
    }
    std::sort(found.begin(), found.end());
    return found;
}

} // namespace keiko
