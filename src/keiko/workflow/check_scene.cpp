#include "keiko/workflow/check_scene.h"

#include "keiko/workflow/judged_body.h"
#include "keiko/workflow/zoned_limits.h"

namespace keiko {

Inspection check_scene(const Scene& scene, const CheckOptions& options, const Job& job) {
    constexpr double limiting = 0.5;
    const JudgedParts parts{options.join, options.joints, options.acceptances};
    JobSteps steps(job, limiting + parts.weight());
    const FaceLimits limits = limits_in(scene, options.preset, options.scope, steps.next(limiting));
    return judged_body(scene.model, limits, parts, steps);
}

} // namespace keiko
