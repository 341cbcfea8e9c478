#pragma once

#include "keiko/intersect/hit/intersection.h"
#include "keiko/intersect/kernels/sub_patch_kernels.h"
#include "keiko/intersect/subpatch/traced_model.h"

#include <vector>

namespace keiko {

/// Every root of a ray of a block on one sub-patch with a regular frame by Krawczyk's method in
/// boxes, a vector of them side by side: for rays too low over the sub-patch for the first look.
/// Untested, as bezier_clipping. False, with nothing appended, when boxes stay undecided down to
/// where only clipping helps, as near a tangency.
bool interval_newton(const TracedModel& model, const SubPatchKernels& kernels, std::uint32_t placed,
                     const RayPacket& rays, std::size_t lane, std::vector<Crossing>& found);

} // namespace keiko
