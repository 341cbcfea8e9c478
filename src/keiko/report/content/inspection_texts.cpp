#include "keiko/report/content/inspection_texts.h"

#include "keiko/base/text.h"
#include "keiko/report/markup/html_text.h"

#include <map>
#include <tuple>

namespace keiko {
namespace {

/// mm; shorter gaps between seams that follow each other along a border are rounding.
constexpr double least_length = 0.05;

/// True for a stretch that fails before its curvature, or the slope of that, is judged.
bool hides_curvature(const MeasuredSeam& seam, const CriteriaPreset& limits) {
    if (seam.kind != SeamClass::smooth) return false;
    if (!seam.curvature) return limits.curvature || limits.curvature_slope;
    return limits.curvature_slope && seam.curvature->worst.verdict != Verdict::pass;
}

} // namespace

std::string value_text(const Check& check) {
    if (check.unit == "1") return short_number(100 * check.worst.value, 3) + " %";
    return short_number(check.worst.value, 3) + (check.unit == "deg" ? "°" : " " + check.unit);
}

std::string subject_of(const Check& check) {
    if (!check.view.empty()) return "lines over " + check.faces + " in view " + check.view;
    if (check.seam == no_index) return check.faces;
    return "seam " + std::to_string(check.seam + 1) + " (" + check.faces + ")";
}

std::string placed_message(const Check& check) {
    return check.faces + ": " + check.message + ", at " + place_text(check.worst.place);
}

std::string unmet_borders(const ModelFacts& facts) {
    if (facts.free_length < least_length) return "";
    return fixed_number(facts.free_length, 1) + " of " + fixed_number(facts.border_length, 1) +
           " mm of borders meet no other";
}

std::string nothing_judged(const Inspection& inspection) {
    const std::size_t faces = inspection.facts.placed_faces;
    if (faces < 2 || !inspection.seams.empty()) return "";
    if (inspection.scope && inspection.scope->all_seams > 0)
        return "no seam was judged: none is on a face in the scope";
    return "no seam was judged: of " + std::to_string(faces) +
           " faces no two have borders that run along each other within the join distance, " +
           short_number(inspection.join) + " mm";
}

std::string joints_not_judged(const Inspection& inspection) {
    const JointLimits& limits = inspection.preset.joint;
    const bool of_a_design = limits.gap || limits.flush || limits.radius;
    if (!inspection.joints)
        return of_a_design ? "no joint was judged: [joint] has limits, but joints were not sought"
                           : "";
    if (inspection.joints->empty())
        return "no joint was found: no two panels end side by side within " +
               short_number(inspection.preset.joint.widest) + " mm";
    if (of_a_design || limits.parallelism) return "";
    return "no joint was judged: the preset " + inspection.preset.name +
           " has no limits in [joint]";
}

std::string curvature_not_judged(const Inspection& inspection) {
    std::vector<std::string> names;
    for (const std::uint32_t index : inspection.accepted_seams) {
        const MeasuredSeam& seam = inspection.seams[index];
        if (hides_curvature(seam, limits_of(inspection, seam)))
            names.push_back("seam " + std::to_string(index + 1) + " (" + seam.faces + ")");
    }
    if (names.empty()) return "";
    return "the curvature was not judged where what comes before it fails and is accepted: " +
           comma_list(names);
}

std::vector<FoldedRemark> folded_remarks(const Diagnostics& remarks) {
    const auto key = [](const Diagnostic& r) { return std::tie(r.severity, r.entity, r.message); };
    std::map<std::tuple<Severity, std::string, std::string>, std::size_t> times;
    for (const Diagnostic& remark : remarks) ++times[key(remark)];
    std::vector<FoldedRemark> folded;
    for (const Diagnostic& remark : remarks) {
        const auto found = times.find(key(remark));
        if (found == times.end()) continue;
        std::string text = remark.entity + (remark.entity.empty() ? "" : ": ") + remark.message;
        if (found->second > 1) text += " (" + std::to_string(found->second) + " times)";
        folded.push_back({remark.severity, std::move(text)});
        times.erase(found);
    }
    return folded;
}

std::string_view name_of(Severity severity) {
    switch (severity) {
        case Severity::note:
            return "note";
        case Severity::warning:
            return "warning";
        case Severity::error:
            return "error";
    }
    return "";
}

} // namespace keiko
