#pragma once

#include "keiko/intersect/kernels/ray_packet.h"
#include "keiko/intersect/subpatch/packed_sub_patch.h"

namespace keiko {

/// Result of the existence test (docs/theory/intersector.md#the-existence-test) of a sub-patch, for
/// each ray of a block. A lane in none of the masks misses the sub-patch, meets it
/// outside of its range of s, or where there is no material.
struct ExistenceResult {
    LaneMask certain = 0;   ///< exactly one root on the sub-patch, and that on its patch
    LaneMask material = 0;  ///< of `certain`: the root is material
    LaneMask single = 0;    ///< at most one
    LaneMask undecided = 0; ///< nothing: boxes or clipping can tell
    /// Bounds of the root's distance, if there is one, for lanes of `certain` and `single`.
    alignas(64) RayPacket::Lanes<double> nearest;
    alignas(64) RayPacket::Lanes<double> farthest; ///< mm along the ray, as `nearest`
};

/// The roots of rays that have at most one on a sub-patch.
struct SubPatchRoots {
    LaneMask found = 0;  ///< a root on the sub-patch, to within `error`
    LaneMask failed = 0; ///< nothing is known, as where rounding was in the way
    /// Place in the frame's square [-1, 1]^2, for lanes of `found`.
    alignas(64) RayPacket::Lanes<double> x;
    alignas(64) RayPacket::Lanes<double> y;     ///< the other coordinate of the place
    alignas(64) RayPacket::Lanes<double> error; ///< bound of how far x and y are off the exact root
    alignas(64) RayPacket::Lanes<double> s;     ///< mm along the ray from its start
};

/// Homogeneous components of a point, (w X, w Y, w Z, w).
using Component4 = std::array<double, 4>;

/// Roots of a ray on a sub-patch: places of its [-1, 1]^2 with bounds of their errors, as small as
/// rounding lets them be. Each was the only one in a box; the same root may stand in two of them,
/// found from either side of the boxes' common border.
struct RootBoxes {
    static constexpr std::size_t capacity = 128; ///< most roots; a search that may find more fails

    std::size_t count = 0;                        ///< roots in use, from the first on
    using Numbers = std::array<double, capacity>; ///< One number of each root.
    alignas(64) Numbers x;                        ///< place
    alignas(64) Numbers y;                        ///< place
    alignas(64) Numbers half_x;                   ///< bound of the error of x
    alignas(64) Numbers half_y;                   ///< bound of the error of y
    Numbers s;                                    ///< mm along the ray from its start
};

/// A homogeneous surface and its derivatives by its parameters.
struct HomogeneousJet {
    alignas(32) Component4 value; ///< (w x, w y, w z, w)
    alignas(32) Component4 du;    ///< first derivative by u
    alignas(32) Component4 dv;    ///< first derivative by v
    alignas(32) Component4 duu;   ///< second derivative by u
    alignas(32) Component4 duv;   ///< second derivative by u and v
    alignas(32) Component4 dvv;   ///< second derivative by v
};

/// The tests of rays against one sub-patch, made for one instruction set. On each of them a ray
/// gets the same bits whatever stands in the other lanes; between them the last bits differ.
struct SubPatchKernels {
    const char* name; ///< of the instruction set
    /// Makes traced rays of the rays of a block, and its masks; `count` and `rays` are given.
    void (*enter)(const SceneBall&, RayPacket&);
    /// The existence test for the lanes of a mask (existence_test-inl.h).
    void (*existence_test)(const RayPacket&, LaneMask, const PackedSubPatch&, ExistenceResult&);
    /// The existence test for a single lane.
    void (*existence_test_single)(const RayPacket&, std::size_t lane, const PackedSubPatch&,
                                  ExistenceResult&);
    /// Newton's method with a proved bound, for lanes that `existence_test` called certain or
    /// single, on the sub-patch's coefficients.
    void (*solve)(const RayPacket&, LaneMask, const PackedSubPatch&, const Component4*,
                  SubPatchRoots&);
    /// Solves a single lane, with the same bits as `solve`.
    void (*solve_single)(const RayPacket&, std::size_t lane, const PackedSubPatch&,
                         const Component4*, SubPatchRoots&);
    /// Solves with a sub-patch for each lane, all of one array, and all sub-patches' coefficients.
    void (*solve_apart)(const RayPacket&, LaneMask, const RayPacket::Lanes<const PackedSubPatch*>&,
                        const Component4*, SubPatchRoots&);
    /// Krawczyk's method in one box a lane, for rays that `existence_test` leaves undecided on a
    /// sub-patch with bounds: it fails where they may have several roots, or are next to a
    /// tangency.
    void (*narrow)(const RayPacket&, LaneMask, const PackedSubPatch&, const Component4*,
                   SubPatchRoots&);
    /// All roots of a single lane by the same method in boxes, many side by side. False when boxes
    /// stay undecided down to where only clipping helps, as near a tangency.
    bool (*find_roots)(const RayPacket&, std::size_t lane, const PackedSubPatch&, const Component4*,
                       RootBoxes&);
    /// Jet of control points, to second order. Requires degrees of at least 1.
    HomogeneousJet (*evaluate)(const BezierPatchView&, const Vec2&);
    /// Surface data of hits on their sub-patches, all at once.
    void (*evaluate_hits)(HitPacket&);
};

/// Kernels for the widest instruction set that this processor has.
SubPatchKernels sub_patch_kernels();

} // namespace keiko
