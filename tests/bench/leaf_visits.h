#pragma once

#include "keiko/intersect/kernels/leaf_kernels.h"
#include "keiko/intersect/subpatch/traced_model.h"
#include "keiko/intersect/traversal/embree_scene.h"

#include "tests/bench/contender.h"

#include <vector>

namespace keiko::bench {

/// Rays of one block at one leaf.
struct LeafVisit {
    std::size_t block = 0;
    std::uint32_t leaf = 0; ///< index among the placed leaves
    LaneMask rays = 0;      ///< that the leaf's box did not rule out
    LaneMask solved = 0;    ///< of those: first to be proved to meet material, and there alone
};

/// The (ray, leaf) pairs that a search for nearest hits comes to, in its order.
struct LeafVisits {
    std::vector<RayBlock> blocks;
    std::vector<LeafVisit> visits;

    std::size_t pairs() const;
    std::size_t solved() const;
};

/// `mode` as the tracer has it: rays one by one, or blocks of 16, coherent ones as packets. A ray's
/// visits end behind its first certain root.
LeafVisits leaf_visits(const TracedModel& model, const EmbreeScene& boxes,
                       const LeafKernels& kernels, std::span<const Ray> rays, Mode mode);

} // namespace keiko::bench
