#pragma once

#include "keiko/intersect/kernels/hit_block.h"
#include "keiko/intersect/kernels/ray_block.h"
#include "keiko/intersect/subpatch/hot_leaf.h"

namespace keiko {

/// What a first look at a leaf proves for each ray of a block. A lane in none of the masks misses
/// the leaf, meets it outside of its range of s, or where there is no material.
struct LeafLook {
    LaneMask certain = 0;   ///< exactly one root on the leaf, and that on its patch
    LaneMask material = 0;  ///< of `certain`: the root is material
    LaneMask single = 0;    ///< at most one
    LaneMask undecided = 0; ///< nothing: boxes or clipping can tell
    /// Where the root is if there is one, for lanes of `certain` and `single`.
    alignas(64) RayBlock::Lanes<double> nearest, farthest;
};

/// The roots of rays that have at most one on a leaf.
struct LeafRoots {
    LaneMask found = 0;
    LaneMask failed = 0; ///< nothing is known, as where rounding was in the way
    /// By lane of `found`: place in the frame's square [-1, 1]^2, bound of the distance to the
    /// exact root in the larger of the two coordinates, distance along the ray.
    alignas(64) RayBlock::Lanes<double> x, y, error, s;
};

using Component4 = std::array<double, 4>;

/// Roots of a ray on a leaf: places of its [-1, 1]^2 with bounds of their errors, as small as
/// rounding lets them be. Each was the only one in a box; the same root may stand in two of them,
/// found from either side of the boxes' common border.
struct RootBoxes {
    static constexpr std::size_t capacity = 128;

    std::size_t count = 0;
    alignas(64) std::array<double, capacity> x, y, half_x, half_y;
    std::array<double, capacity> s; ///< mm along the ray
};

/// A homogeneous surface and its derivatives by its parameters.
struct HomogeneousJet {
    alignas(32) Component4 value, du, dv, duu, duv, dvv;
};

/// The tests of rays against one leaf, made for one instruction set. On each of them a ray gets the
/// same bits whatever stands in the other lanes; between them the last bits differ.
struct LeafKernels {
    const char* name; ///< of the instruction set
    /// Makes traced rays of the rays of a block, and its masks; `count` and `rays` are given.
    void (*enter)(const SceneBall&, RayBlock&);
    /// Stage 0 of docs/theory/intersector.md for the lanes of a mask.
    void (*look)(const RayBlock&, LaneMask, const HotLeaf&, LeafLook&);
    /// The same for a single lane.
    void (*look_single)(const RayBlock&, std::size_t lane, const HotLeaf&, LeafLook&);
    /// Newton's method with a proved bound, for lanes that `look` called certain or single, on
    /// the leaf's coefficients.
    void (*solve)(const RayBlock&, LaneMask, const HotLeaf&, const Component4*, LeafRoots&);
    void (*solve_single)(const RayBlock&, std::size_t lane, const HotLeaf&, const Component4*,
                         LeafRoots&);
    /// The same with a leaf for each lane, all of one array, and all leaves' coefficients.
    void (*solve_apart)(const RayBlock&, LaneMask, const RayBlock::Lanes<const HotLeaf*>&,
                        const Component4*, LeafRoots&);
    /// Krawczyk's method in one box a lane, for rays that `look` leaves undecided on a leaf with
    /// bounds: it fails where they may have several roots, or are next to a tangency.
    void (*narrow)(const RayBlock&, LaneMask, const HotLeaf&, const Component4*, LeafRoots&);
    /// All roots of a single lane by the same method in boxes, many side by side. False when boxes
    /// stay undecided down to where only clipping helps, as near a tangency.
    bool (*find_roots)(const RayBlock&, std::size_t lane, const HotLeaf&, const Component4*,
                       RootBoxes&);
    /// Of control points, to second order. Requires degrees of at least 1.
    HomogeneousJet (*evaluate)(const BezierPatchView&, const Vec2&);
    /// Of the leaves of hits, all at once, with what a hit tells of the surface.
    void (*evaluate_hits)(HitBlock&);
};

/// The widest that this processor has.
LeafKernels leaf_kernels();

} // namespace keiko
