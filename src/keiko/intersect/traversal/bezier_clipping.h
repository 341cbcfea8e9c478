#pragma once

#include "keiko/intersect/hit/hit.h"
#include "keiko/intersect/kernels/ray_packet.h"
#include "keiko/intersect/kernels/sub_patch_kernels.h"
#include "keiko/intersect/subpatch/traced_model.h"

#include <vector>

namespace keiko {

// The roots of a ray on one sub-patch. HitFilter tests which of them are hits.

/// Every root of a ray on one sub-patch by RootFinder, whatever the sub-patch's shape: for
/// sub-patches and rays on which no quick proof holds. Untested: neither by range nor by trim
/// curves. `clipping_only` as TracerOptions has it. Appends to `found`, in no order.
void bezier_clipping(const TracedModel& model, std::uint32_t placed, const TracedRay& ray,
                     bool clipping_only, std::vector<Crossing>& found);

/// Every root of a ray of a block on one sub-patch with a regular frame, by Krawczyk's method in
/// boxes, a vector of them side by side. It serves rays too low over the sub-patch for the
/// existence test. Its roots are untested, as those of bezier_clipping. False, with nothing
/// appended, when boxes stay undecided down to where only clipping helps, as near a tangency.
bool interval_newton(const TracedModel& model, const SubPatchKernels& kernels, std::uint32_t placed,
                     const RayPacket& rays, std::size_t lane, std::vector<Crossing>& found);

} // namespace keiko
