#include "keiko/inspect/seams/curvature_match.h"
#include "keiko/inspect/seams/seam_quantities.h"
#include "keiko/report/content/profiles_text.h"
#include "keiko/report/json/json_parts.h"

namespace keiko {
namespace {

Json optional_json(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json quantity_json(const std::optional<ProfileQuantity>& quantity, const char* unit) {
    if (!quantity) return {};
    return {{"unit", unit},
            {"largest", quantity->largest},
            {"bound", quantity->bound},
            {"along", quantity->along},
            {"place", point(quantity->place)},
            {"limit", optional_json(quantity->limit)},
            {"judged", quantity->judged},
            {"beyond", quantity->limit ? Json{{"share", quantity->beyond.value},
                                              {"bound", quantity->beyond.bound}}
                                       : Json()}};
}

Json curvature_json(const SeamProfile& profile, const CriteriaPreset& preset) {
    Json json = quantity_json(profile.curvature, "1");
    if (json.is_null()) return json;
    const CurvatureFormula formula = SeamQuantities(preset).curvature_limit().formula;
    json["formula"] = name_of(formula);
    json["formula_text"] = formula_text(formula);
    return json;
}

Json sample_json(const ProfileSample& s) {
    const SeamPoint& p = s.point;
    Json json = {{"along", s.along},
                 {"piece", s.piece},
                 {"place", point(p.place)},
                 {"gap", p.gap},
                 {"angle", optional_json(p.angle)}};
    if (!p.angle) return json;
    json["curvatures"] = {p.curvature_a, p.curvature_b};
    json["alias"] = s.alias, json["catia"] = s.catia;
    json["slopes"] = {p.slope_a, p.slope_b};
    json["slope_change"] = optional_json(s.slope);
    return json;
}

} // namespace

Json profile_json(const SeamProfile& profile, const Inspection& inspection) {
    const MeasuredSeam& seam = inspection.seams[profile.seam];
    Json json = {{"seam", profile.seam + 1},
                 {"line", seam.line + 1},
                 {"faces", seam.faces},
                 {"face_ids", {seam.id_a, seam.id_b}},
                 {"instances", {seam.instance_a, seam.instance_b}},
                 {"kind", name_of(seam.kind)},
                 {"scrap", seam.scrap},
                 {"internal", seam.internal},
                 {"verdict", name_of(seam.verdict)},
                 {"length", profile.length},
                 {"gap", quantity_json(profile.gap, "mm")},
                 {"angle", quantity_json(profile.angle, "deg")},
                 {"curvature", curvature_json(profile, limits_of(inspection, seam))},
                 {"curvature_slope", quantity_json(profile.slope, "deg")},
                 {"samples", Json::array()}};
    for (const ProfileSample& sample : profile.samples)
        json["samples"].push_back(sample_json(sample));
    return json;
}

std::string profiles_json(std::span<const SeamProfile> profiles, const Inspection& inspection,
                          const std::string& tool_version) {
    Json json = {{"format", "keiko-profiles/1"},
                 {"tool", {{"name", "keiko"}, {"version", tool_version}}},
                 {"model", inspection.facts.source},
                 {"preset", inspection.preset.name},
                 {"profiles", Json::array()}};
    for (const SeamProfile& profile : profiles)
        json["profiles"].push_back(profile_json(profile, inspection));
    constexpr int one_line = -1;
    return json.dump(one_line, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace keiko
