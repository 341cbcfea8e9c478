#pragma once

#include "keiko/base/export.h"
#include "keiko/report/content/triaged_faults.h"
#include "keiko/workflow/open_scene.h"

namespace KEIKO_API keiko {

/// The faults of a judged scene, and the profiles of the first most_profiles of them that stretches
/// show. `inspection`: of the scene's body. Throws Cancelled.
TriagedFaults scene_faults(const Scene& scene, const Inspection& inspection, const Job& job = {});

} // namespace keiko
