#pragma once

#include "keiko/math/bounds.h"
#include "keiko/triage/fault_units.h"

#include <cstddef>
#include <vector>

namespace keiko {

/// Units that are mended together, by their indices.
struct FaultGroup {
    std::vector<std::size_t> units; ///< those of the most weight first
    Sight sight;                    ///< of all of them, at the place of the first
    bool mirrored = false;          ///< it is on both sides of the middle plane
};

/// Groups units, and orders the groups by what the standing views see of them. Stretches
/// of one line are one group, and so are those that go on where the other ends. So are images of
/// each other at the middle plane of the body across y. Stretches with gaps are grouped apart from
/// those without. Jumps of curvature that are too fine for an eye are one group, all over the body.
/// What lies in one glance with a worse fault belongs to it, hidden faults to hidden ones; what is
/// mended by other means has to touch it. `body`: its box, mm. Stops as a parallel loop does.
std::vector<FaultGroup> fault_groups(const Inspection& inspection,
                                     const std::vector<FaultUnit>& units, const Box3& body);

} // namespace keiko
