#pragma once

#include "keiko/trace/crossing.h"
#include "keiko/trace/leaf_kernels.h"
#include "keiko/trace/traced_model.h"

namespace keiko {

/// Everything about a hit, in world coordinates.
Hit evaluated(const TracedModel& model, const LeafKernels& kernels, const Crossing& crossing,
              bool second_derivatives);

} // namespace keiko
