#include "keiko/report/content/report.h"

namespace keiko {
namespace {

ShownItem item_of(const TriageItem& fault) {
    const bool is_of_seam = fault.face == no_index && !fault.seams.empty();
    return {&fault, is_of_seam ? fault.seams.front() : no_index, fault.face, fault.place};
}

} // namespace

std::vector<ShownItem> shown_items(const Report& report) {
    std::vector<ShownItem> items;
    for (const TriageItem& fault : report.triage.items)
        if (items.size() < most_shown) items.push_back(item_of(fault));
    if (!items.empty()) return items;
    for (const std::uint32_t seam : worst_seams(report.inspection, worst_seam_count))
        items.push_back({nullptr, seam, no_index, worst_place(report.inspection.seams[seam])});
    return items;
}

std::vector<std::uint32_t> first_seams(const Report& report, std::size_t most) {
    const std::vector<MeasuredSeam>& all = report.inspection.seams;
    std::vector<std::uint32_t> seams;
    const auto add = [&](std::uint32_t seam) {
        if (seams.size() < most && std::find(seams.begin(), seams.end(), seam) == seams.end())
            seams.push_back(seam);
    };
    for (const ShownItem& item : shown_items(report))
        if (item.seam != no_index) add(item.seam);
    for (const std::uint32_t seam : worst_seams(report.inspection, all.size()))
        if (all[seam].verdict != Verdict::pass) add(seam);
    return seams;
}

} // namespace keiko
