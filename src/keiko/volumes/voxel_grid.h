#pragma once

#include "keiko/math/rgb.h"
#include "keiko/math/trilinear.h"
#include "keiko/math/vec.h"

#include <array>
#include <cassert>
#include <cstddef>
#include <utility>
#include <vector>

namespace keiko {

/// Values on the nodes of a grid, stored as `Number`, trilinear between them. Places are in steps
/// between nodes, from the first, and lie within the grid.
template <class Number>
class VoxelGridOf {
public:
    /// Grid of at least two nodes along each axis; one value a node, x fastest, then y. `colors` of
    /// coloured voxels: three channels a node.
    VoxelGridOf(const std::array<int, 3>& nodes, std::vector<Number> values,
                std::vector<Number> colors = {})
        : nodes_(nodes), values_(std::move(values)), colors_(std::move(colors)) {
        row_ = static_cast<std::size_t>(nodes[0]);
        layer_ = row_ * static_cast<std::size_t>(nodes[1]);
        assert(values_.size() == layer_ * static_cast<std::size_t>(nodes[2]));
        assert(colors_.empty() || colors_.size() == 3 * values_.size());
    }

    /// Number of nodes along x, y and z.
    const std::array<int, 3>& nodes() const { return nodes_; }
    /// Values of the nodes, x fastest, then y.
    const std::vector<Number>& values() const { return values_; }
    /// True if the nodes have colours of their own.
    bool colored() const { return !colors_.empty(); }
    /// Number of a node in values().
    std::size_t index(std::size_t x, std::size_t y, std::size_t z) const {
        return x + row_ * y + layer_ * z;
    }

    /// Value at a place.
    double value(const Vec3& place) const { return value_of(values_, place); }
    /// Another quantity of the nodes at a place, in the order of values().
    double value_of(const std::vector<Number>& quantity, const Vec3& place) const {
        const GridCell cell = grid_cell(place, nodes_);
        const std::size_t first = index(cell.node[0], cell.node[1], cell.node[2]);
        return trilinear(cell.t, [&](std::size_t x, std::size_t y, std::size_t z) {
            return static_cast<double>(quantity[first + index(x, y, z)]);
        });
    }
    /// Colour at a place of coloured voxels.
    Rgb color(const Vec3& place) const {
        const GridCell cell = grid_cell(place, nodes_);
        return trilinear(cell.t, [&](std::size_t x, std::size_t y, std::size_t z) {
            const Number* color =
                &colors_[3 * index(cell.node[0] + x, cell.node[1] + y, cell.node[2] + z)];
            return Rgb(static_cast<double>(color[0]), static_cast<double>(color[1]),
                       static_cast<double>(color[2]));
        });
    }
    /// Gradient at a node by central differences, per step; at borders half the difference to the
    /// one neighbour.
    Vec3 node_gradient(std::size_t x, std::size_t y, std::size_t z) const {
        const std::array<std::size_t, 3> node{x, y, z}, stride{1, row_, layer_};
        const std::size_t here = index(x, y, z);
        Vec3 gradient(0);
        for (unsigned axis = 0; axis < 3; ++axis) {
            const bool first = node[axis] == 0;
            const bool last = node[axis] + 1 == static_cast<std::size_t>(nodes_[axis]);
            const auto before = static_cast<double>(values_[first ? here : here - stride[axis]]);
            const auto after = static_cast<double>(values_[last ? here : here + stride[axis]]);
            gradient[axis] = (after - before) / 2;
        }
        return gradient;
    }
    /// Gradient at a place, trilinear between those of the nodes, per step.
    Vec3 gradient(const Vec3& place) const {
        const GridCell cell = grid_cell(place, nodes_);
        return trilinear(cell.t, [&](std::size_t x, std::size_t y, std::size_t z) {
            return node_gradient(cell.node[0] + x, cell.node[1] + y, cell.node[2] + z);
        });
    }

private:
    std::array<int, 3> nodes_;
    std::size_t row_ = 0, layer_ = 0; ///< nodes in a row along x, and in a layer of z
    std::vector<Number> values_, colors_;
};

/// Voxels as scenes hold them.
using VoxelGrid = VoxelGridOf<float>;

} // namespace keiko
