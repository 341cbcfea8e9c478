#include "keiko/report/content/report.h"

namespace keiko {

std::vector<ShownItem> shown_items(const Report& report) {
    const Inspection whole = whole_inspection(report);
    std::vector<ShownItem> items;
    for (const TriageItem& fault : report.triage.items) {
        if (items.size() == most_shown) break;
        items.push_back({&fault, fault.seams.empty() ? no_index : fault.seams.front(), fault.face,
                         worst_place(fault, whole)});
    }
    if (!items.empty()) return items;
    for (const std::uint32_t seam : worst_seams(report.inspection, worst_seam_count))
        items.push_back({nullptr, seam, no_index, worst_place(report.inspection.seams[seam])});
    return items;
}

} // namespace keiko
