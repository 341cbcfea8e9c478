#pragma once

#include "keiko/trace/hot_leaf.h"
#include "keiko/trace/ray_block.h"

namespace keiko {

/// What a first look at a leaf proves for each ray of a block. A lane in none of the masks misses
/// the leaf, or meets it outside of its range of s.
struct LeafLook {
    LaneMask certain = 0;   ///< exactly one root on the leaf, and that on its patch
    LaneMask single = 0;    ///< at most one
    LaneMask undecided = 0; ///< nothing: only clipping can tell
    /// Where the root is if there is one, for lanes of `certain` and `single`.
    alignas(64) RayBlock::Lanes<double> nearest, farthest;
};

/// The roots of rays that have at most one on a leaf.
struct LeafRoots {
    LaneMask found = 0;
    LaneMask failed = 0; ///< rounding was in the way
    /// By lane of `found`: place in the frame's square [-1, 1]^2, bound of the distance to the
    /// exact root in the larger of the two coordinates, distance along the ray.
    alignas(64) RayBlock::Lanes<double> x, y, error, s;
};

using Component4 = std::array<double, 4>;

/// Two planes through a ray, as two functions of a leaf's homogeneous components: the ray meets
/// the leaf where both vanish.
struct PlanePair {
    std::array<Component4, 2> weights{};
    std::array<double, 2> bend{};  ///< bounds of |xx| + 2 |xy| + |yy| over the leaf
    std::array<double, 2> noise{}; ///< bounds of the functions' errors
};

/// A rectangle of a leaf's [-1, 1]^2.
struct LeafBox {
    double x = 0, y = 0, half_x = 1, half_y = 1;
    bool single = false; ///< holds at most one root
    bool root = false;   ///< holds exactly one, and is as narrow as rounding lets it be
};

/// The two tests of a ray block against one leaf, made for one instruction set. On any of them,
/// and whatever stands in the other lanes, a ray gets the same bits.
struct LeafKernels {
    const char* name; ///< of the instruction set
    /// Stage 0 of docs/theory/intersector.md for the lanes of a mask.
    void (*look)(const RayBlock&, LaneMask, const HotLeaf&, LeafLook&);
    /// The same for a block of a single ray.
    void (*look_single)(const RayBlock&, const HotLeaf&, LeafLook&);
    /// Newton's method with a proved bound, for lanes that `look` called certain or single, on
    /// the leaf's coefficients.
    void (*solve)(const RayBlock&, LaneMask, const HotLeaf&, const Component4*, LeafRoots&);
    void (*solve_single)(const RayBlock&, const HotLeaf&, const Component4*, LeafRoots&);
    /// One step of Krawczyk's method in each of up to 8 boxes: what is left of them, each in one
    /// piece or in two, replaces them. Requires room for 16.
    std::size_t (*narrow)(const PlanePair&, const HotLeaf&, const Component4*, std::size_t count,
                          LeafBox* boxes);
};

/// The widest that this processor has.
LeafKernels leaf_kernels();

} // namespace keiko
