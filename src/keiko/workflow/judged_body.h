#pragma once

#include "keiko/base/job_steps.h"
#include "keiko/inspect/inspection.h"

namespace keiko {

/// The judged parts of a body, and the findings that are left out of the verdict.
struct JudgedParts {
    double join = 0.5;                 ///< mm within which borders are a seam
    bool joints = false;               ///< of panels that stand apart, too
    const AcceptanceList& acceptances; ///< findings that have no part in the verdict

    /// Weight of judged_body(), where choosing the limits of the faces weighs 0.5.
    double weight() const;
};

/// Inspects a body, its symmetry and its joints, in steps of the weight of `parts`. Throws
/// Cancelled.
Inspection judged_body(const SurfaceModel& model, const FaceLimits& limits,
                       const JudgedParts& parts, JobSteps& steps);

} // namespace keiko
