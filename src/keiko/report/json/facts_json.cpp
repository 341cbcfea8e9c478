#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/markup/json_text.h"

namespace keiko {
namespace {

template <class Value>
Json or_null(const std::optional<Value>& value) {
    return value ? Json(*value) : Json();
}

Json box_json(const Box3& box) {
    if (box.empty()) return nullptr;
    return {{"lower", point(box.lower)}, {"upper", point(box.upper)}};
}

Json tracing_json(const TraceFacts& facts) {
    Json json = {{"sub_patches", facts.sub_patches},
                 {"mixed_sub_patches", facts.mixed_sub_patches},
                 {"trimmed_away_sub_patches", facts.trimmed_away_sub_patches},
                 {"bytes", facts.bytes}};
    if (facts.build_milliseconds) json["build_milliseconds"] = *facts.build_milliseconds;
    return json;
}

Json part_json(const PartFacts& part) {
    return {{"name", part.name},
            {"faces", part.faces},
            {"patches", part.patches},
            {"instances", part.instances},
            {"mirrored_instances", part.mirrored_instances}};
}

Json face_json(const FaceFacts& face) {
    Json json = {{"id", face.id},
                 {"name", face.name},
                 {"part", face.part},
                 {"layer", face.layer},
                 {"color", Json()},
                 {"surface_kind", face.surface_kind},
                 {"patches", face.patches},
                 {"degree", face.degree},
                 {"rational", face.rational},
                 {"loops", face.loops},
                 {"approximated", face.approximated}};
    if (face.color) json["color"] = {face.color->r, face.color->g, face.color->b};
    return json;
}

Json lost_face_json(const LostFace& face) {
    return {{"id", face.id}, {"name", face.name}, {"reason", face.reason}};
}

Json repair_json(const Repair& repair) {
    Json json = {{"face", repair.face},
                 {"kind", name_of(repair.kind)},
                 {"count", repair.count},
                 {"size", repair.size}};
    if (!repair.detail.empty()) json["detail"] = repair.detail;
    return json;
}

Json repair_totals_json(const std::map<RepairKind, RepairTotal>& totals) {
    Json json = Json::object();
    for (const auto& [kind, total] : totals)
        json[std::string(name_of(kind))] = {
            {"count", total.count}, {"faces", total.faces}, {"size", total.size}};
    return json;
}

Json remark_json(const Diagnostic& remark) {
    return {{"severity", name_of(remark.severity)},
            {"entity", remark.entity},
            {"message", remark.message}};
}

template <class List, class Of>
Json array_of(const List& list, const Of& json_of) {
    Json array = Json::array();
    for (const auto& item : list) array.push_back(json_of(item));
    return array;
}

Json degree_json(const std::pair<const std::array<int, 2>, std::size_t>& degree) {
    return {{"u", degree.first[0]}, {"v", degree.first[1]}, {"patches", degree.second}};
}

} // namespace

Json diagnostics_json(const Diagnostics& diagnostics) {
    return array_of(diagnostics, remark_json);
}

Json model_json(const ModelFacts& facts) {
    const RemarkCounts& remarks = facts.remarks;
    Json json = {
        {"source", facts.source},
        {"file_format", facts.format},
        {"unit", facts.unit.empty() ? Json() : Json(facts.unit)},
        {"millimetres_per_unit", or_null(facts.millimetres_per_unit)},
        {"parts", facts.parts},
        {"instances", facts.instances},
        {"part_list", array_of(facts.part_list, part_json)},
        {"faces", facts.faces},
        {"placed_faces", facts.placed_faces},
        {"trimmed_faces", facts.trimmed_faces},
        {"approximated_faces", facts.approximated_faces},
        {"largest_approximation", facts.largest_approximation},
        {"patches", facts.patches},
        {"rational_patches", facts.rational_patches},
        {"surface_kinds", facts.kinds},
        {"degrees", array_of(facts.degrees, degree_json)},
        {"bounds", box_json(facts.bounds)},
        {"edges", facts.edges},
        {"degenerate_edges", facts.degenerate_edges},
        {"largest_edge_tolerance", facts.largest_edge_tolerance},
        {"join", facts.join},
        {"seams", facts.seams},
        {"border_length", facts.border_length},
        {"free_border_length", facts.free_length},
        {"lost_faces", array_of(facts.lost_faces, lost_face_json)},
        {"repair_totals", repair_totals_json(facts.repair_totals)},
        {"repairs", array_of(facts.repairs, repair_json)},
        {"remarks",
         {{"notes", remarks.notes}, {"warnings", remarks.warnings}, {"errors", remarks.errors}}},
        {"diagnostics", diagnostics_json(facts.diagnostics)}};
    json["tracing"] = facts.tracing ? tracing_json(*facts.tracing) : Json();
    return json;
}

std::string facts_json(const ModelFacts& facts) {
    Json json = {{"format", "keiko-model-facts/1"}};
    json.update(model_json(facts));
    json["face_list"] = array_of(facts.face_list, face_json);
    return text_of(json);
}

} // namespace keiko
