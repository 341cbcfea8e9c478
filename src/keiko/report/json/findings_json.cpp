#include "keiko/report/content/acceptance_texts.h"
#include "keiko/report/json/json_parts.h"

namespace keiko {
namespace {

Json note_json(const AcceptanceNote& note) {
    Json json = {{"who", note.who}, {"why", note.why}, {"when", note.when}};
    json["until"] = note.until.empty() ? Json() : Json(note.until);
    return json;
}

} // namespace

Json measured_json(const MeasuredValue& w) {
    return {{"value", w.value},
            {"bound", w.bound},
            {"limit", w.limit},
            {"verdict", name_of(w.verdict)},
            {"place", point(w.place)}};
}

Json finding_json(const Check& finding) {
    const bool look = finding.severity == Check::Severity::look;
    Json json = {
        {"code", finding.code}, {"rule", finding.rule}, {"severity", look ? "look" : "judged"}};
    if (!finding.view.empty()) json["view"] = finding.view;
    if (finding.seam != no_index) json["seam"] = finding.seam + 1;
    if (finding.face != no_index) json["face"] = finding.face + 1;
    json["faces"] = finding.faces;
    json["quantity"] = finding.quantity;
    json["unit"] = finding.unit;
    if (!finding.formula.empty()) json["formula"] = finding.formula;
    json.update(measured_json(finding.worst));
    json["message"] = finding.message;
    if (finding.accepted) json["accepted"] = note_json(*finding.accepted);
    return json;
}

Json findings_json(const Inspection& inspection) {
    Json json = Json::array();
    for (const auto* checks : {&inspection.findings, &inspection.looks})
        for (const Check& check : *checks) {
            Json numbered = {{"number", json.size() + 1}};
            numbered.update(finding_json(check));
            json.push_back(std::move(numbered));
        }
    return json;
}

Json accepted_json(const Inspection& inspection) {
    Json json = Json::array();
    for (const Check& check : inspection.accepted) json.push_back(finding_json(check));
    return json;
}

Json acceptance_remarks_json(const Inspection& inspection) {
    Json json = Json::array();
    for (const AcceptanceRemark& remark : inspection.acceptance_remarks)
        json.push_back(text_of(remark));
    return json;
}

} // namespace keiko
