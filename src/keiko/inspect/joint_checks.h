#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/check.h"
#include "keiko/inspect/joints/joint.h"
#include "keiko/scene/joint_limits.h"

#include <vector>

namespace keiko {

struct Inspection;

/// Criteria of joints held against one joint, in the order gap, flush, parallelism, radius; those
/// without a limit are left out. Beside places that cannot be measured nothing passes. Without
/// face.
std::vector<Check> checks_of(const Joint& joint, const JointLimits& limits);

/// Finds the joints between the panels of an inspected model (find_joints) by the limits of its
/// preset. Adds them, and their checks, to the inspection; each check is of the first panel's face.
/// Throws Cancelled.
void check_joints(const SurfaceModel& model, Inspection& inspection, const Job& job = {});

} // namespace keiko
