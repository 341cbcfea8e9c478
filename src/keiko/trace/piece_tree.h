#pragma once

#include "keiko/trace/view_volume.h"

#include <cstdint>
#include <vector>

namespace keiko {

/// The box and the normals of something small: a cone of half angle `angle` rad about a unit
/// vector; an angle above pi / 2 says nothing.
struct PieceBound {
    Box3 box;
    Vec3 normal{0, 0, 1};
    double angle = 4;
    double sine = 0, cosine = -1; ///< of the angle
};

/// A binary tree over pieces of surface or of its borders.
class PieceTree {
public:
    PieceTree() = default;
    explicit PieceTree(std::vector<PieceBound> bounds);

    /// Appends the pieces whose boxes `volume` may hold and that the apex may see edge-on, in a
    /// fixed order.
    void find(const ViewVolume& volume, const Apex& apex, std::vector<std::uint32_t>& found) const;
    /// Whether any box overlaps this one.
    bool touches(const Box3& box) const;

private:
    struct Node {
        PieceBound bound;
        std::uint32_t first = 0, count = 0; ///< of order_; an inner node where right is not 0
        std::uint32_t right = 0;            ///< the left child follows its parent
    };
    std::uint32_t build(std::uint32_t first, std::uint32_t count);

    std::vector<PieceBound> bounds_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

} // namespace keiko
