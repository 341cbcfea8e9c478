#include "keiko/inspect/seams/curvature_match.h"
#include "keiko/report/json/json_parts.h"

namespace keiko {
namespace {

Json waviness_json(const WavinessLimit& limit) {
    return {{"depth", limit.depth}, {"window", limit.window}, {"waves_only", limit.waves_only}};
}

/// The limits that the preset has.
Json structure_json(const StructureLimits& limits) {
    Json json = Json::object();
    const auto add = [&json](const char* key, const auto& limit) {
        if (limit) json[key] = *limit;
    };
    add("degree", limits.degree);
    add("spans", limits.spans);
    add("knot_distance", limits.knot_distance);
    add("width_ratio", limits.width_ratio);
    add("patch_edge", limits.patch_edge);
    add("degenerate_edge", limits.degenerate_edge);
    add("corner_angle", limits.corner_angle);
    add("control_turn", limits.control_turn);
    add("control_twist", limits.control_twist);
    add("control_ratio", limits.control_ratio);
    add("control_distance", limits.control_distance);
    add("short_edge", limits.short_edge);
    add("small_face", limits.small_face);
    add("identical_face", limits.identical_face);
    add("identical_edge", limits.identical_edge);
    add("self_distance", limits.self_distance);
    add("loop_crossing", limits.loop_crossing);
    add("edge_gap", limits.edge_gap);
    add("edge_angle", limits.edge_angle);
    add("edge_degree", limits.edge_degree);
    add("edge_knot_distance", limits.edge_knot_distance);
    return json;
}

} // namespace

Json limits_json(const CriteriaPreset& preset) {
    Json json = {{"gap", preset.gap},
                 {"angle", preset.angle},
                 {"curvature", Json()},
                 {"feature_angle", preset.feature_angle},
                 {"fading", preset.fading},
                 {"longest_run_out", preset.longest_run_out},
                 {"negligible", preset.negligible},
                 {"flat_radius", preset.flat_radius}};
    if (preset.curvature)
        json["curvature"] = {{"formula", name_of(preset.curvature->formula)},
                             {"formula_text", formula_text(preset.curvature->formula)},
                             {"limit", preset.curvature->limit}};
    if (preset.curvature_slope) json["curvature_slope"] = *preset.curvature_slope;
    json["minimum_radius"] =
        preset.surface.minimum_radius ? Json(*preset.surface.minimum_radius) : Json();
    if (const auto& draft = preset.surface.draft)
        json["draft"] = {{"angle", draft->angle},
                         {"pull", {draft->pull.x, draft->pull.y, draft->pull.z}}};
    for (const WavinessLimit& limit : preset.surface.waviness)
        json["waviness"].push_back(waviness_json(limit));
    for (const WavinessLimit& limit : preset.look.waviness)
        json["look"]["waviness"].push_back(waviness_json(limit));
    if (preset.look.symmetry) json["look"]["symmetry"] = *preset.look.symmetry;
    if (const auto& symmetry = preset.surface.symmetry)
        json["symmetry"] = {{"plane", symmetry->plane.text()}, {"distance", symmetry->distance}};
    if (preset.structure != StructureLimits{}) json["structure"] = structure_json(preset.structure);
    return json;
}

Json preset_json(const CriteriaPreset& preset) {
    Json json = {{"name", preset.name}, {"source", preset.source}, {"caveat", preset.caveat}};
    json.update(limits_json(preset));
    return json;
}

} // namespace keiko
