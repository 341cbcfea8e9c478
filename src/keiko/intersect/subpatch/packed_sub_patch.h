#pragma once

#include "keiko/intersect/subpatch/sub_patch.h"
#include "keiko/intersect/subpatch/trim_cells.h"

namespace keiko {

/// All that most rays ever read of a placed sub-patch: its frame in world coordinates with the
/// bounds that prove a miss, or a single root. Five cache lines, apart from the control points.
struct alignas(64) PackedSubPatch {
    /// Frame coordinates of a world point P: rows * (P - center). These numbers define the frame
    /// exactly; what their rounding costs is in `blur`.
    std::array<double, 3> center{};
    std::array<std::array<double, 3>, 3> rows{};
    std::array<double, 3> row_length{};
    double blur = 0;   ///< mm: bound of how far the stored polynomial is from the exact surface
    double height = 0; ///< bound of |Z|
    /// Of the deviations e_u, e_v, e_n, e_w of SubPatchFrame.
    std::array<double, 4> value{}, slope{}, bend{};
    std::uint32_t polynomial = 0; ///< where its coefficients begin in SubPatchSet::polynomials
    std::uint8_t degree_u = 1, degree_v = 1;
    bool regular = false;  ///< the bounds mean something
    bool rational = false; ///< otherwise the weight is 1
    bool material = false; ///< wholly inside the trim loops as far as its patch goes
    /// Where the patch ends, in x and y: a sub-patch may go on beyond it, for seams.
    std::array<double, 2> patch_low{}, patch_high{};
    TrimCells cells{}; ///< of a sub-patch that is not `material`

    std::size_t coefficients() const {
        return (degree_u + std::size_t{1}) * (degree_v + std::size_t{1});
    }
    bool on_patch(double x, double y) const {
        return patch_low[0] <= x && x <= patch_high[0] && patch_low[1] <= y && y <= patch_high[1];
    }

    /// Makes every look at the sub-patch end undecided.
    void set_unbounded();
};

struct PartPlacement;

static_assert(sizeof(PackedSubPatch) == 320);

/// The record of a sub-patch at a placement.
PackedSubPatch packed_sub_patch(const SubPatchSet& sub_patches, std::uint32_t sub_patch,
                                const PartPlacement& placement);

} // namespace keiko
