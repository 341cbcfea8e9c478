#pragma once

#include "keiko/math/vec.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace keiko {

/// One piece of a curve in a chain of pieces.
struct ChainLink {
    std::size_t piece = 0; ///< into the pieces given
    bool turned = false;   ///< runs from its second end to its first
};

/// Pieces of a curve in the order along it.
struct CurveChain {
    std::vector<ChainLink> links; ///< at least one
    bool closed = false; ///< it ends where it begins; one piece alone does so within 1e-5 mm only
};

/// Chains of curve pieces, which are given by both their ends and joined where ends are within
/// `reach` mm, the nearest first along each chain. Every piece is in one chain. The first piece of
/// a chain in the order given is not turned. The chain begins with it if the chain is closed or if
/// no piece joins the first of its ends.
std::vector<CurveChain> chain_curves(std::span<const std::array<Vec3, 2>> ends, double reach);

} // namespace keiko
