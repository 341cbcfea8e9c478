#pragma once

#include "keiko/intersect/kernels/sub_patch_kernels.h"
#include "keiko/intersect/subpatch/traced_model.h"
#include "keiko/intersect/traversal/embree_scene.h"

#include "tests/bench/contender.h"

#include <vector>

namespace keiko::bench {

/// Rays of one block at one sub-patch.
struct LeafVisit {
    std::size_t block = 0;
    std::uint32_t sub_patch = 0; ///< index among the placed sub-patches
    LaneMask rays = 0;           ///< that the sub-patch's box did not rule out
    LaneMask solved = 0;         ///< of those: first to be proved to meet material, and there alone
};

/// The (ray, sub-patch) pairs that a search for nearest hits comes to, in its order.
struct LeafVisits {
    std::vector<RayPacket> blocks;
    std::vector<LeafVisit> visits;

    std::size_t pairs() const;
    std::size_t solved() const;
};

/// `mode` as the tracer has it: rays one by one, or blocks of 16, coherent ones as packets. A ray's
/// visits end behind its first certain root.
LeafVisits leaf_visits(const TracedModel& model, const EmbreeScene& boxes,
                       const SubPatchKernels& kernels, std::span<const Ray> rays, Mode mode);

} // namespace keiko::bench
