#pragma once

#include "keiko/intersect/hit/crossing.h"
#include "keiko/intersect/kernels/leaf_kernels.h"
#include "keiko/intersect/subpatch/traced_model.h"

#include <vector>

namespace keiko {

/// Every root of a ray of a block on one leaf with a regular frame by Krawczyk's method in boxes, a
/// vector of them side by side: for rays too low over the leaf for the first look. Untested, as
/// clipped_roots. False, with nothing appended, when boxes stay undecided down to where only
/// clipping helps, as near a tangency.
bool narrowed_roots(const TracedModel& model, const LeafKernels& kernels, std::uint32_t placed,
                    const RayBlock& rays, std::size_t lane, std::vector<Crossing>& found);

} // namespace keiko
