#pragma once

#include "keiko/math/bounds.h"
#include "keiko/triage/fault_group.h"
#include "keiko/triage/fault_units.h"

#include <vector>

namespace keiko {

/// Groups units, and orders the groups by what the standing views see of them. Stretches
/// of one line are one group, and so are those that go on where the other ends. So are images of
/// each other at the middle plane of the body across y. Stretches with gaps are grouped apart from
/// those without. Jumps of curvature that are too fine for an eye are one group, all over the body.
/// Faults of a bad patch (bad_patches.h) are one. What lies in one glance with a worse fault
/// belongs to it, hidden faults to hidden ones; what is mended by other means has to touch it.
/// `body`: its box, mm. Stops as a parallel loop does.
std::vector<FaultGroup> fault_groups(const Inspection& inspection,
                                     const std::vector<FaultUnit>& units, const Box3& body);

} // namespace keiko
