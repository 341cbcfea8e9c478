#include "keiko/visibility/silhouettes/bounds_tree.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr std::uint32_t leaf_size = 4; ///< most pieces of a node without children

/// A cone that holds both.
void extend(PieceBound& a, const PieceBound& b) {
    a.box.extend(b.box);
    const double between = angle_between(a.normal, b.normal);
    if (between + b.angle <= a.angle) return;
    if (between + a.angle <= b.angle) {
        a.normal = b.normal, a.angle = b.angle;
        return;
    }
    const double angle = (a.angle + between + b.angle) / 2;
    if (angle < std::numbers::pi / 2 && between > 0) {
        const double turn = angle - a.angle;
        const Vec3 across = (b.normal - a.normal * a.normal.dot(b.normal)).normalized();
        a.normal = (a.normal * std::cos(turn) + across * std::sin(turn)).normalized();
    }
    a.angle = angle;
}

void make_ready(PieceBound& bound) {
    bound.sine = std::sin(bound.angle);
    bound.cosine = std::cos(bound.angle);
    bound.radius = bound.box.size() / 2;
}

} // namespace

BoundsTree::BoundsTree(std::vector<PieceBound> bounds) : bounds_(std::move(bounds)) {
    order_.resize(bounds_.size());
    for (std::uint32_t i = 0; i < order_.size(); ++i) order_[i] = i;
    for (PieceBound& bound : bounds_) make_ready(bound);
    if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

std::uint32_t BoundsTree::build(std::uint32_t first, std::uint32_t count) {
    const auto self = static_cast<std::uint32_t>(nodes_.size());
    Node node{bounds_[order_[first]], first, count, 0};
    Box3 centers;
    for (std::uint32_t k = first; k < first + count; ++k) {
        extend(node.bound, bounds_[order_[k]]);
        centers.extend(bounds_[order_[k]].box.center());
    }
    make_ready(node.bound);
    nodes_.push_back(node);
    if (count <= leaf_size) return self;
    const Vec3 extent = centers.extent();
    const unsigned axis = extent.x >= extent.y && extent.x >= extent.z ? 0
                          : extent.y >= extent.z                       ? 1
                                                                       : 2;
    const auto begin = order_.begin() + first;
    std::nth_element(
        begin, begin + count / 2, begin + count, [&](std::uint32_t a, std::uint32_t b) {
            const double x = bounds_[a].box.center()[axis], y = bounds_[b].box.center()[axis];
            return x != y ? x < y : a < b;
        });
    build(first, count / 2);
    const std::uint32_t right = build(first + count / 2, count - count / 2);
    nodes_[self].right = right;
    return self;
}

bool BoundsTree::may_be_edge_on(const PieceBound& bound, const Viewpoint& viewpoint) {
    constexpr double slack = 1e-9;
    if (!(bound.angle < std::numbers::pi / 2)) return true;
    const Vec3 way = viewpoint.way_to(bound.box.center());
    const double radius = viewpoint.infinite() ? 0 : bound.radius, squared = way.length2();
    if (!(radius * radius < squared)) return true;
    const double beside = std::sqrt(squared - radius * radius), room = slack * (beside + radius);
    if (!(bound.cosine * beside - bound.sine * radius > room)) return true;
    return std::abs(way.dot(bound.normal)) <= bound.sine * beside + bound.cosine * radius + room;
}

bool BoundsTree::touches(const Box3& box) const {
    std::array<std::uint32_t, 64> todo;
    std::size_t depth = 0;
    if (!nodes_.empty()) todo[depth++] = 0;
    while (depth > 0) {
        const std::uint32_t index = todo[--depth];
        const Node& node = nodes_[index];
        if (!node.bound.box.overlaps(box)) continue;
        if (node.right != 0) {
            todo[depth++] = node.right;
            todo[depth++] = index + 1;
            continue;
        }
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
            if (bounds_[order_[k]].box.overlaps(box)) return true;
    }
    return false;
}

} // namespace keiko
