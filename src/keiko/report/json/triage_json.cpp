#include "keiko/report/json/json_parts.h"

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
            {"length", item.length},
            {"visible", item.visible},
            {"width", item.width},
            {"weight", item.weight},
            {"view", item.view},
            {"mirrored", item.mirrored}};
}

} // namespace

Json triage_json(const Triage& triage) {
    Json json = {{"items", Json::array()}, {"hidden", Json::array()}};
    for (const TriageItem& item : triage.items) json["items"].push_back(item_json(item));
    for (const TriageItem& item : triage.hidden) json["hidden"].push_back(item_json(item));
    return json;
}

} // namespace keiko
