#pragma once

#include "keiko/inspect/inspection.h"
#include "keiko/scene/symmetry.h"
#include "keiko/triage/fault_units.h"

namespace keiko {

/// True for two stretches, or two openings, that are images of each other at a plane: to a
/// hundredth of their length, and not on the plane.
bool are_mirror_images(const Inspection& inspection, const FaultUnit& a, const FaultUnit& b,
                       const MirrorPlane& mirror);

} // namespace keiko
