#pragma once

#include "keiko/intersect/hit/intersection.h"
#include "keiko/intersect/kernels/traced_ray.h"
#include "keiko/intersect/subpatch/traced_model.h"

#include <vector>

namespace keiko {

/// Every root of a ray on one sub-patch by RootFinder, whatever the sub-patch's shape: for
/// sub-patches and rays on which no quick proof holds. Untested: neither by range nor by trim
/// curves. `clipping_only` as TracerOptions has it. Appends to `found`, in no order.
void bezier_clipping(const TracedModel& model, std::uint32_t placed, const TracedRay& ray,
                     bool clipping_only, std::vector<Crossing>& found);

} // namespace keiko
