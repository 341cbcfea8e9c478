#include "keiko/workflow/scene_faults.h"

#include "keiko/base/job_steps.h"
#include "keiko/report/content/report.h"
#include "keiko/workflow/check_models.h"

#include <algorithm>

namespace keiko {
namespace {

/// The first stretch of each item, those to mend first before those that are hidden.
std::vector<std::uint32_t> first_stretches(const Triage& triage) {
    std::vector<std::uint32_t> seams;
    for (const auto* items : {&triage.items, &triage.hidden})
        for (const TriageItem& item : *items)
            if (!item.seams.empty() && seams.size() < most_profiles &&
                std::find(seams.begin(), seams.end(), item.seams.front()) == seams.end())
                seams.push_back(item.seams.front());
    return seams;
}

} // namespace

TriagedFaults scene_faults(const Scene& scene, const Inspection& inspection, const Job& job) {
    constexpr double ordering = 2, drawing = 1;
    JobSteps steps(job, ordering + drawing);
    TriagedFaults faults;
    faults.triage =
        triage(scene.model, scene.tracer, inspection, scene.ground(), steps.next(ordering));
    faults.profiles =
        profiles_of(scene.model, inspection, first_stretches(faults.triage), steps.next(drawing));
    return faults;
}

} // namespace keiko
