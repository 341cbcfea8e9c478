#include "keiko/geometry/bvh/box_tree.h"

#include "keiko/base/job.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>

namespace keiko {
namespace {

constexpr std::uint32_t sub_patch_size = 4;

unsigned longest_axis(const Box3& box) {
    const Vec3 e = box.extent();
    return e.x >= e.y && e.x >= e.z ? 0 : (e.y >= e.z ? 1 : 2);
}

} // namespace

BoxTree::BoxTree(std::vector<Box3> boxes) : boxes_(std::move(boxes)) {
    for (std::uint32_t i = 0; i < boxes_.size(); ++i)
        if (!boxes_[i].empty() && std::isfinite(boxes_[i].size())) order_.push_back(i);
    if (!order_.empty()) build(0, static_cast<std::uint32_t>(order_.size()));
}

std::uint32_t BoxTree::build(std::uint32_t first, std::uint32_t count) {
    const auto self = static_cast<std::uint32_t>(nodes_.size());
    Node node;
    node.first = first, node.count = count;
    Box3 centers;
    for (std::uint32_t k = first; k < first + count; ++k) {
        node.box.extend(boxes_[order_[k]]);
        centers.extend(boxes_[order_[k]].center());
    }
    nodes_.push_back(node);
    if (count <= sub_patch_size) return self;

    const unsigned axis = longest_axis(centers);
    const auto begin = order_.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const double x = boxes_[a].center()[axis], y = boxes_[b].center()[axis];
                         return x != y ? x < y : a < b;
                     });
    build(first, count / 2);
    nodes_[self].right = build(first + count / 2, count - count / 2);
    return self;
}

std::vector<std::uint32_t> BoxTree::overlapping(const Box3& box) const {
    std::vector<std::uint32_t> found;
    any_of([&](const Box3& other) { return other.overlaps(box); },
           [&](std::uint32_t number) {
               found.push_back(number);
               return false;
           });
    std::sort(found.begin(), found.end());
    return found;
}

void BoxTree::visit_near(const Vec3& p, double radius,
                         const std::function<double(std::uint32_t)>& visit) const {
    struct Waiting {
        double square;
        bool box;
        std::uint32_t index;
        bool operator<(const Waiting& other) const {
            return square != other.square ? square > other.square : index > other.index;
        }
    };
    const auto square = [&](const Box3& box) { return (box.nearest(p) - p).length2(); };
    std::priority_queue<Waiting> waiting;
    const auto push = [&](std::uint32_t node) {
        waiting.push({square(nodes_[node].box), false, node});
    };
    if (!nodes_.empty()) push(0);
    while (!waiting.empty() && waiting.top().square <= radius * radius) {
        const Waiting next = waiting.top();
        waiting.pop();
        if (next.box) {
            check_stop();
            radius = visit(next.index);
            continue;
        }
        const Node& node = nodes_[next.index];
        if (node.right != 0) {
            push(next.index + 1);
            push(node.right);
            continue;
        }
        for (std::uint32_t k = node.first; k < node.first + node.count; ++k)
            waiting.push({square(boxes_[order_[k]]), true, order_[k]});
    }
}

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
