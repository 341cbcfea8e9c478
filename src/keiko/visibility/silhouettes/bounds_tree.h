#pragma once

#include "keiko/visibility/silhouettes/view_volume.h"

#include <array>
#include <cstdint>
#include <vector>

namespace keiko {

/// The box and the normals of something small: a cone of half angle `angle` rad about a unit
/// vector; an angle above pi / 2 says nothing.
struct PieceBound {
    Box3 box;                     ///< world, mm
    Vec3 normal{0, 0, 1};         ///< unit, axis of the cone
    double angle = 4;             ///< rad, half angle of the cone
    double sine = 0, cosine = -1; ///< of the angle
    double radius = 0;            ///< mm, of the ball around the box
};

/// A binary tree over pieces of surface or of its borders.
class BoundsTree {
public:
    BoundsTree() = default;
    /// Tree over some bounds, which find() and any() number in this order. Sines, cosines and radii
    /// are set here.
    explicit BoundsTree(std::vector<PieceBound> bounds);

    /// Calls `visit(piece, sides)` for the pieces whose boxes `volume` may hold and that the
    /// viewpoint may see edge-on, in a fixed order; `sides`: those of the volume that the box is
    /// not proved to lie inside of.
    template <class Visit>
    void find(const ViewVolume& volume, const Viewpoint& viewpoint, const Visit& visit) const {
        any(
            volume, [&](const PieceBound& bound) { return may_be_edge_on(bound, viewpoint); },
            [&](std::uint32_t piece, ViewVolume::Sides sides) {
                visit(piece, sides);
                return false;
            });
    }
    /// Whether `found(piece, sides)`, in the same order, says so of any piece whose box `volume`
    /// may hold and whose bound `counts`, as those of all that hold it do.
    template <class Counts, class Found>
    bool any(const ViewVolume& volume, const Counts& counts, const Found& found) const {
        struct Open {
            std::uint32_t node;
            ViewVolume::Sides sides;
        };
        std::array<Open, 64> todo;
        std::size_t depth = 0;
        if (!nodes_.empty()) todo[depth++] = {0, volume.all_sides()};
        while (depth > 0) {
            auto [index, sides] = todo[--depth];
            const Node& node = nodes_[index];
            if (!volume.may_hold(node.bound.box, sides) || !counts(node.bound)) continue;
            if (node.right != 0) {
                todo[depth++] = {node.right, sides};
                todo[depth++] = {index + 1, sides};
                continue;
            }
            for (std::uint32_t k = node.first; k < node.first + node.count; ++k) {
                const PieceBound& bound = bounds_[order_[k]];
                ViewVolume::Sides of_piece = sides;
                if (volume.may_hold(bound.box, of_piece) && counts(bound) &&
                    found(order_[k], of_piece))
                    return true;
            }
        }
        return false;
    }
    /// Whether any box overlaps this one.
    bool touches(const Box3& box) const;

private:
    struct Node {
        PieceBound bound;
        std::uint32_t first = 0, count = 0; ///< of order_; an inner node where right is not 0
        std::uint32_t right = 0;            ///< the left child follows its parent
    };
    /// False when no line from the viewpoint through the box can be tangent to a surface with these
    /// normals: by the sum of the cone's angle and half of the box's.
    static bool may_be_edge_on(const PieceBound& bound, const Viewpoint& viewpoint);
    std::uint32_t build(std::uint32_t first, std::uint32_t count);

    std::vector<PieceBound> bounds_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace keiko
