#pragma once

#include "keiko/base/job.h"
#include "keiko/inspect/inspection.h"

namespace keiko {

/// Measures how far a body is from its own mirror image, where the preset of its inspection has a
/// limit for it, and adds the check to the inspection, of the face that is furthest off. The bound
/// is what the nearest points are not proved to; that no place is worse is sought, not proved
/// (docs/theory/inspection.md). Throws Cancelled.
void check_symmetry(const SurfaceModel& model, Inspection& inspection, const Job& job = {});

} // namespace keiko
