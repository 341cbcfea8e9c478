#pragma once

#include "keiko/intersect/kernels/sub_patch_kernels.h"

namespace keiko::bench {

/// Kernels that do what SubPatchKernels would do without proofs, on the same records and for the
/// same rays. They show what the proofs cost.
struct BareKernels {
    /// The strips alone: `undecided` for lanes that may meet the sub-patch, nothing about how
    /// often.
    void (*existence_test)(const RayPacket&, LaneMask, const PackedSubPatch&, ExistenceResult&);
    void (*existence_test_single)(const RayPacket&, std::size_t lane, const PackedSubPatch&,
                                  ExistenceResult&);
    /// Newton's method until a step is so small that the next would be rounding; no bound.
    void (*solve)(const RayPacket&, LaneMask, const PackedSubPatch&, const Component4*,
                  SubPatchRoots&);
    void (*solve_single)(const RayPacket&, std::size_t lane, const PackedSubPatch&,
                         const Component4*, SubPatchRoots&);
};

/// The widest that this processor has.
BareKernels bare_kernels();

} // namespace keiko::bench
