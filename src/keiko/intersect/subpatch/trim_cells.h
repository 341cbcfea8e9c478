#pragma once

#include "keiko/math/bounds.h"

#include <algorithm>
#include <cstdint>

namespace keiko {

struct SubPatch;
struct PatchFrame;
struct FaceTrim;

/// A sub-patch's square [-1, 1]^2 as 8 x 8 cells that are material or not, where that is the same
/// for the whole cell: most roots on a sub-patch that trim curves cross need no curve. No cell is
/// either where no curve crosses the sub-patch.
struct TrimCells {
    /// Set of cells: bit 8 j + i is the i-th in x of the j-th row in y.
    using Set = std::uint64_t;

    Set material = 0; ///< inside the trim loops, and on the patch
    Set empty = 0;    ///< outside of them, farther than any seam reaches

    explicit operator bool() const { return (material | empty) != 0; }
    /// Those that a box of the square meets; what is beyond the square counts for the cells at its
    /// border.
    static Set met(const Box2& box) {
        const unsigned left = index(box.lower.x), right = index(box.upper.x);
        const unsigned bottom = index(box.lower.y), top = index(box.upper.y);
        const Set row = (0xffU >> (7 - right)) & (0xffU << left);
        const Set rows = (~Set{0} >> 8 * (7 - top)) & (~Set{0} << 8 * bottom);
        return row * 0x0101010101010101U & rows;
    }
    /// The one that holds a place.
    static Set at(const Vec2& place) { return Set{1} << (8 * index(place.y) + index(place.x)); }

private:
    static unsigned index(double place) {
        return static_cast<unsigned>(std::clamp(4 * (place + 1), 0.0, 7.0));
    }
};

/// Those of a sub-patch of a face, in its part.
TrimCells trim_cells(const SubPatch& sub_patch, const PatchFrame& patch, const FaceTrim& trim);

} // namespace keiko
