#include "keiko/report/content/view_facts.h"
#include "keiko/report/json/json_parts.h"

namespace keiko {
namespace {

Json color(const Rgb& c) {
    return {c.r, c.g, c.b};
}

Json box_json(const Box3& box) {
    return {{"lower", point(box.lower)}, {"upper", point(box.upper)}};
}

std::string_view word_of(MirrorModel model) {
    if (model == MirrorModel::flat) return "flat";
    return model == MirrorModel::tube ? "tube" : "exact";
}

Json plane_json(const CPlane& plane) {
    return {{"origin", point(plane.origin)},
            {"u", point(plane.u)},
            {"v", point(plane.v)},
            {"lamps", plane.lamps},
            {"pitch", plane.spacing()},
            {"diameter", plane.diameter},
            {"luminance", color(plane.luminance)},
            {"caps", plane.luminous_caps ? "luminous" : "dark"},
            {"mirror", word_of(plane.mirror)}};
}

Json rig_value(const LightRig& rig) {
    Json planes = Json::array();
    std::size_t others = 0;
    for (const LightSource& source : rig.sources)
        if (const auto* plane = std::get_if<CPlane>(&source))
            planes.push_back(plane_json(*plane));
        else
            ++others;
    return {{"format", "keiko-view-rig/1"},  {"name", rig.name},
            {"planes", std::move(planes)},   {"other_lights", others},
            {"ambient", color(rig.ambient)}, {"medium", rig.medium.has_value()}};
}

/// Index of refraction, n + ik, by channel, and whether the interface is a mirror.
Json material_json(const Material& material) {
    Json json{{"name", material.name},
              {"mirror", !material.roughness.has_value()},
              {"diffuse", color(material.metal ? Rgb(0) : material.diffuse)},
              {"n", color(material.metal ? material.metal->n : Rgb(material.refractive_index))},
              {"k", color(material.metal ? material.metal->k : Rgb(0))}};
    json["metal"] = material.metal.has_value();
    return json;
}

Json faces_json(const ViewFacts& facts) {
    Json faces = Json::array();
    for (const ViewedFace& face : facts.faces)
        faces.push_back({{"id", face.id},
                         {"name", face.name},
                         {"layer", face.layer},
                         {"material", face.material},
                         {"part", face.part}});
    return faces;
}

Json views_json(const std::vector<NamedView>& all) {
    Json views = Json::array();
    for (const NamedView& view : all)
        views.push_back({{"name", view.name}, {"camera", camera_json(view.camera)}});
    return views;
}

} // namespace

std::string view_json(const ViewFacts& facts, const LightRig& rig) {
    Json materials = Json::array();
    for (const Material& material : facts.materials) materials.push_back(material_json(material));
    Json json{{"format", "keiko-view-facts/1"},
              {"tool", {{"name", "keiko"}, {"version", facts.tool_version}}},
              {"inputs", facts.inputs},
              {"view", facts.view},
              {"camera", camera_json(facts.camera)},
              {"bounds", box_json(facts.bounds)},
              {"ground", nullptr},
              {"background", color(facts.background)},
              {"reflections", facts.reflections},
              {"min_weight", facts.min_weight},
              {"materials", std::move(materials)},
              {"parts", facts.parts},
              {"faces", faces_json(facts)},
              {"views", views_json(facts.views)},
              {"own_views", views_json(facts.own_views)},
              {"remarks", diagnostics_json(facts.remarks)},
              {"against", facts.against},
              {"rig", rig_value(rig)}};
    if (facts.ground) json["ground"] = {{"z", *facts.ground}, {"material", facts.ground_material}};
    return text_of(json);
}

std::string rig_json(const LightRig& rig) {
    return text_of(rig_value(rig));
}

std::string placed_rig_json(const Placement& placement) {
    return text_of({{"format", "keiko-view-placement/1"},
                    {"coverage", placement.coverage},
                    {"remarks", diagnostics_json(placement.diagnostics)},
                    {"rig", rig_value(placement.rig)}});
}

} // namespace keiko
