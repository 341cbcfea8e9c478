#pragma once

#include "keiko/intersect/subpatch/sub_patch.h"
#include "keiko/math/bounds.h"

#include <algorithm>
#include <cstdint>

namespace keiko {

struct SubPatch;
struct PatchFrame;
struct FaceTrim;

/// A sub-patch's square [-1, 1]^2 as 8 x 8 cells that are material or not, where that is the same
/// for the whole cell. Most roots on a sub-patch that trim curves cross need no curve. No cell is
/// either where no curve crosses the sub-patch.
struct TrimCells {
    /// Set of cells: bit 8 j + i is the i-th in x of the j-th row in y.
    using Set = std::uint64_t;

    Set material = 0; ///< inside the trim loops, and on the patch
    Set empty = 0;    ///< outside of them, farther than any seam reaches

    /// True if any cell is material or empty.
    explicit operator bool() const { return (material | empty) != 0; }
    /// Cells that a box of the square meets; places beyond the square count for the cells at its
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

/// Cells of a sub-patch of a face, in its part.
TrimCells trim_cells(const SubPatch& sub_patch, const PatchFrame& patch, const FaceTrim& trim);

/// All that most rays ever read of a placed sub-patch: its frame in world coordinates with the
/// bounds that prove a miss, or a single root. Five cache lines, apart from the control points.
struct alignas(64) PackedSubPatch {
    /// Frame coordinates of a world point P: rows * (P - center). These numbers define the frame
    /// exactly; what their rounding costs is in `blur`.
    std::array<double, 3> center{};
    std::array<std::array<double, 3>, 3> rows{}; ///< 1 / mm
    std::array<double, 3> row_length{};          ///< bound of each row's length, 1 / mm
    double blur = 0;   ///< mm: bound of how far the stored polynomial is from the exact surface
    double height = 0; ///< bound of |Z|
    /// Bounds of the deviations e_u, e_v, e_n, e_w of SubPatchFrame.
    std::array<double, 4> value{}, slope{}, bend{};
    std::uint32_t polynomial = 0; ///< where its coefficients begin in SubPatchSet::polynomials
    std::uint8_t degree_u = 1, degree_v = 1; ///< at least 1
    bool regular = false;                    ///< the bounds mean something
    bool rational = false;                   ///< otherwise the weight is 1
    bool material = false; ///< wholly inside the trim loops as far as its patch goes
    /// Ends of the patch, in x and y: a sub-patch may go on beyond it, for seams.
    std::array<double, 2> patch_low{}, patch_high{};
    TrimCells cells{}; ///< of a sub-patch that is not `material`

    /// Number of coefficients, each of four components, and of control points.
    std::size_t coefficients() const {
        return (degree_u + std::size_t{1}) * (degree_v + std::size_t{1});
    }
    /// True if a place of the square [-1, 1]^2 lies on the patch itself, its ends included.
    bool on_patch(double x, double y) const {
        return patch_low[0] <= x && x <= patch_high[0] && patch_low[1] <= y && y <= patch_high[1];
    }

    /// Makes every look at the sub-patch end undecided.
    void set_unbounded();
};

struct PartPlacement;

static_assert(sizeof(PackedSubPatch) == 320);

/// Record of the `sub_patch`-th of a set at a placement. It has no cells yet. A sub-patch without a
/// regular frame gets infinite bounds, and neither centre nor rows.
PackedSubPatch packed_sub_patch(const SubPatchSet& sub_patches, std::uint32_t sub_patch,
                                const PartPlacement& placement);

} // namespace keiko
