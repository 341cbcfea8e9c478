#pragma once

#include "keiko/math/vec.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace keiko {

/// A stretch of two borders that may be a seam, or a part of one: files cut borders into as many
/// curves as they like, and a partner's border ends in the middle of others.
struct SeamPiece {
    /// Where it begins or ends on one of its borders, and the way it comes from there out.
    struct Tip {
        Vec3 position{0}, onward{0};
    };
    /// Instance and face of either side.
    std::array<std::uint32_t, 4> faces{};
    std::array<std::array<Tip, 2>, 2> ends{}; ///< the first and the last, on both borders
    double length = 0;                        ///< mm
    double widest = 0;                        ///< mm between the borders
    bool fills_border = false; ///< all but the whole of the shorter border, of two faces or of
                               ///< one that the file closes there
};

/// Which of the pieces are seams. A seam runs along further than it is wide, and further than
/// `join` mm or as far as a whole border. A scrap is a seam where it is one with those that go on
/// from its ends, of the same faces or of the next ones, or where it fills the hole between two
/// seams of its faces. So it does not matter how a border
/// is cut into curves. Where a border turns back, as in the hooks of careless trims, nothing goes
/// on.
std::vector<bool> seams_among(std::span<const SeamPiece> pieces, double join);

} // namespace keiko
