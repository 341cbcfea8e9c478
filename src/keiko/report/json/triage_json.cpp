#include "keiko/report/content/triaged_faults.h"
#include "keiko/report/json/json_parts.h"

#include <algorithm>

namespace keiko {
namespace {

/// Numbers from 1, as tables have them.
template <class Index>
Json numbers(const std::vector<Index>& indices) {
    Json json = Json::array();
    for (const Index index : indices) json.push_back(index + 1);
    return json;
}

Json item_json(const TriageItem& item) {
    return {{"mending", name_of(item.mending)},
            {"findings", numbers(item.findings)},
            {"seams", numbers(item.seams)},
            {"face", item.face == no_index ? Json() : Json(item.face + 1)},
            {"patch", item.patch == no_index ? Json() : Json(item.patch + 1)},
            {"left_of_crease", item.left_of_crease},
            {"length", item.length},
            {"visible", item.visible},
            {"width", item.width},
            {"weight", item.weight},
            {"view", item.view},
            {"mirrored", item.mirrored},
            {"fine", item.fine}};
}

/// The profile of the stretch that shows most of an item, or null.
Json profile_of(const TriageItem& item, const TriagedFaults& faults, const Inspection& inspection) {
    if (item.seams.empty()) return {};
    const auto found = std::find_if(
        faults.profiles.begin(), faults.profiles.end(),
        [&](const SeamProfile& profile) { return profile.seam == item.seams.front(); });
    return found == faults.profiles.end() ? Json() : profile_json(*found, inspection);
}

Json fault_json(const TriageItem& item, const TriagedFaults& faults, const Inspection& inspection) {
    const Check& worst = numbered_check(inspection, item.findings.front());
    Json json = item_json(item);
    json["verdict"] = name_of(worst.worst.verdict);
    json["faces"] = worst.faces;
    json["message"] = worst.message;
    json["place"] = point(item.place);
    json["profile"] = profile_of(item, faults, inspection);
    return json;
}

} // namespace

std::string faults_json(const TriagedFaults& faults, const Inspection& inspection,
                        const std::string& tool_version) {
    Json json = {{"format", "keiko-faults/1"},
                 {"tool", {{"name", "keiko"}, {"version", tool_version}}},
                 {"verdict", name_of(inspection.verdict)},
                 {"preset", inspection.preset.name},
                 {"items", Json::array()},
                 {"hidden", Json::array()}};
    for (const TriageItem& item : faults.triage.items)
        json["items"].push_back(fault_json(item, faults, inspection));
    for (const TriageItem& item : faults.triage.hidden)
        json["hidden"].push_back(fault_json(item, faults, inspection));
    return text_of(json);
}

Json triage_json(const Triage& triage) {
    Json json = {{"items", Json::array()}, {"hidden", Json::array()}};
    for (const TriageItem& item : triage.items) json["items"].push_back(item_json(item));
    for (const TriageItem& item : triage.hidden) json["hidden"].push_back(item_json(item));
    return json;
}

} // namespace keiko
