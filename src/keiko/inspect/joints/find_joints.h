#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/seam/seam.h"
#include "keiko/inspect/joints/joint.h"
#include "keiko/inspect/seams/model_borders.h"
#include "keiko/scene/joint_limits.h"

#include <span>
#include <vector>

namespace keiko {

/// The joints between bodies, faces joined by `seams`, whose skins end side by side and towards
/// each other within `limits.widest` mm (docs/theory/joints.md). In the order of the first panel's
/// borders. Throws Cancelled.
std::vector<Joint> find_joints(const ModelBorders& borders, std::span<const Seam> seams,
                               const JointLimits& limits, const Job& job = {});

} // namespace keiko
