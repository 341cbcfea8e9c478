#include "keiko/workflow/judged_body.h"

#include "keiko/compare/shape/symmetry.h"
#include "keiko/inspect/joint_checks.h"

namespace keiko {
namespace {

constexpr double measuring = 18, imaging = 1, joining = 1;

} // namespace

double JudgedParts::weight() const {
    return measuring + imaging + (joints ? joining : 0);
}

Inspection judged_body(const SurfaceModel& model, const FaceLimits& limits,
                       const JudgedParts& parts, JobSteps& steps) {
    Inspection found = inspect(model, limits, parts.join, steps.next(measuring, inspection_stages));
    check_symmetry(model, found, steps.next(imaging));
    if (parts.joints) check_joints(model, found, steps.next(joining));
    accept_findings(found, parts.acceptances);
    return found;
}

} // namespace keiko
