#pragma once

#include "keiko/math/vec.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace keiko {

/// One piece of a curve in a chain of pieces.
struct ChainLink {
    std::size_t piece = 0;
    bool turned = false; ///< runs from its second end to its first
};

struct CurveChain {
    std::vector<ChainLink> links;
    bool closed = false;
};

/// Chains of curve pieces, which are given by both their ends and joined where ends are within
/// `reach` mm, the nearest first along each chain. Every piece is in one chain. Chains begin with
/// their first piece in the order given, unless both of its ends are joined.
std::vector<CurveChain> chain_curves(std::span<const std::array<Vec3, 2>> ends, double reach);

} // namespace keiko
