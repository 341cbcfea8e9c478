#include "keiko/triage/triage.h"

#include "keiko/base/parallel.h"
#include "keiko/triage/crease_end.h"
#include "keiko/triage/fault_groups.h"
#include "keiko/triage/reflection_break.h"
#include "keiko/triage/seam_sight.h"

#include <algorithm>

namespace keiko {
namespace {

void add_sights(const FindingSights& of_findings, const Inspection& inspection,
                std::vector<FaultUnit>& units, const Job& job) {
    std::vector<std::uint32_t> stretches;
    for (const FaultUnit& unit : units)
        if (unit.seam != no_index) stretches.push_back(unit.seam);
    const std::vector<Sight> sights = of_findings.of_stretches(stretches, job);
    parallel_for(units.size(), job, "sights", [&](std::size_t i) {
        FaultUnit& unit = units[i];
        if (unit.seam != no_index) {
            unit.sight = sights[unit.seam];
            return;
        }
        for (const std::size_t finding : unit.findings)
            unit.sight.add(of_findings.of(numbered_check(inspection, finding)));
    });
}

/// Degrees that are left of a crease where it ends at a stretch; 0 for other units.
double left_of_crease(const Inspection& inspection, const FaultUnit& unit) {
    if (unit.seam == no_index) return 0;
    const MeasuredSeam& seam = inspection.seams[unit.seam];
    if (!seam.angle || seam.angle->verdict == Verdict::pass) return 0;
    return end_of_crease(inspection, seam) ? seam.smallest_angle : 0;
}

TriageItem item_of(const FaultGroup& group, const std::vector<FaultUnit>& units,
                   const Inspection& inspection) {
    const FaultUnit& first = units[group.units.front()];
    const Sight& sight = group.sight;
    TriageItem item;
    for (const std::size_t i : group.units) {
        const FaultUnit& unit = units[i];
        item.findings.insert(item.findings.end(), unit.findings.begin(), unit.findings.end());
        if (unit.seam != no_index) item.seams.push_back(unit.seam);
    }
    const std::size_t worst = first.findings.front();
    std::sort(item.findings.begin(), item.findings.end());
    std::stable_partition(item.findings.begin(), item.findings.end(),
                          [&](std::size_t finding) { return finding == worst; });
    item.mending = first.mending, item.face = first.face, item.patch = group.patch;
    item.left_of_crease = left_of_crease(inspection, first);
    item.length = sight.length, item.visible = sight.visible_share();
    const std::size_t view = sight.best_view();
    item.view = standing_views[view];
    item.width = sight.width[view], item.weight = break_of_pooled(sight.weight[view]);
    item.torn = sight.torn[view], item.fine = first.is_fine();
    item.mirrored = group.mirrored;
    item.place = sight.place;
    return item;
}

} // namespace

Triage triage(const SurfaceModel& model, const Tracer& tracer, const Inspection& inspection,
              std::optional<double> ground, const Job& job) {
    std::vector<FaultUnit> units = fault_units(inspection);
    if (units.empty()) return {};
    const StopScope scope(job);
    const FindingSights of_findings(model, tracer, inspection, ground);
    std::erase_if(units, [&](const FaultUnit& unit) {
        return !of_findings.is_fault(numbered_check(inspection, unit.findings.front()));
    });
    add_sights(of_findings, inspection, units, job);
    Triage triage;
    for (const FaultGroup& group : fault_groups(inspection, units, tracer.bounds()))
        (group.sight.is_hidden() ? triage.hidden : triage.items)
            .push_back(item_of(group, units, inspection));
    put_fine_among_first(triage.items);
    return triage;
}

void put_fine_among_first(std::vector<TriageItem>& faults) {
    std::size_t stretches = 0;
    for (const TriageItem& fault : faults) stretches += fault.seams.size();
    const auto fine = std::find_if(faults.begin(), faults.end(), [&](const TriageItem& fault) {
        return fault.fine && 2 * fault.seams.size() > stretches;
    });
    if (fine - faults.begin() < std::ptrdiff_t(most_shown) || fine == faults.end()) return;
    std::rotate(faults.begin() + most_shown - 1, fine, fine + 1);
}

} // namespace keiko
