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
    if (limits.degree) json["degree"] = *limits.degree;
    if (limits.spans) json["spans"] = *limits.spans;
    if (limits.knot_distance) json["knot_distance"] = *limits.knot_distance;
    if (limits.patch_edge) json["patch_edge"] = *limits.patch_edge;
    if (limits.degenerate_edge) json["degenerate_edge"] = *limits.degenerate_edge;
    if (limits.corner_angle) json["corner_angle"] = *limits.corner_angle;
    if (limits.short_edge) json["short_edge"] = *limits.short_edge;
    if (limits.small_face) json["small_face"] = *limits.small_face;
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
