#pragma once

#include "keiko/intersect/kernels/leaf_kernels.h"

namespace keiko::bench {

/// What LeafKernels would do without proofs, on the same records and for the same rays, to tell
/// what the proofs cost.
struct BareKernels {
    /// The strips alone: `undecided` for lanes that may meet the leaf, nothing about how often.
    void (*look)(const RayBlock&, LaneMask, const HotLeaf&, LeafLook&);
    void (*look_single)(const RayBlock&, std::size_t lane, const HotLeaf&, LeafLook&);
    /// Newton's method until a step is so small that the next would be rounding; no bound.
    void (*solve)(const RayBlock&, LaneMask, const HotLeaf&, const Component4*, LeafRoots&);
    void (*solve_single)(const RayBlock&, std::size_t lane, const HotLeaf&, const Component4*,
                         LeafRoots&);
};

/// The widest that this processor has.
BareKernels bare_kernels();

} // namespace keiko::bench
