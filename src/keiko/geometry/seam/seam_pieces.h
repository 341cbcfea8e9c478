#pragma once

#include "keiko/math/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

/// A stretch of two borders that may be a seam, or a part of one: files may cut borders into any
/// number of curves, and a partner's border may end in the middle of others.
struct SeamPiece {
    /// Begin or end on one of its borders, and the outward direction there.
    struct Tip {
        Vec3 position{0}, onward{0};
    };
    /// Instance and face of either side.
    std::array<std::uint32_t, 4> faces{};
    std::array<std::array<Tip, 2>, 2> ends{}; ///< the first and the last, on both borders
    double length = 0;                        ///< mm
    double widest = 0;                        ///< mm between the borders
    bool fills_border = false; ///< almost the whole of the shorter border, of two faces or of one
                               ///< that the file closes there
};

/// Seams among the pieces, one flag a piece. A seam is longer than it is wide, and longer than
/// `join` mm or as long as a whole border. A scrap is a seam together with those that continue it
/// at its ends, of the same faces or of the next ones. It also is one where it fills the hole
/// between two seams of its faces. The result thus does not depend on how a border is cut into
/// curves. Where a border turns back, as in the hooks of careless trims, nothing continues it.
std::vector<bool> seams_among(std::span<const SeamPiece> pieces, double join);

} // namespace keiko
