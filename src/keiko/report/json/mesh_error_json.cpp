#include "keiko/raster/shading_rule.h"
#include "keiko/report/content/mesh_error.h"
#include "keiko/report/json/json_parts.h"

namespace keiko {
namespace {

Json name_or_null(const std::string& name) {
    return name.empty() ? Json() : Json(name);
}

Json quantiles_json(const SizeQuantiles& sizes) {
    return {{"median", sizes.median}, {"p99", sizes.p99}, {"largest", sizes.largest}};
}

Json pixels_json(const FacePixels& pixels) {
    return {{"all", pixels.all}, {"inside", pixels.inside}};
}

Json errors_json(const MeshErrors& e) {
    return {{"body", e.body},
            {"compared", e.compared},
            {"wrong", e.wrong},
            {"reversed", e.reversed},
            {"missed", pixels_json(e.missed)},
            {"added", pixels_json(e.added)},
            {"other_face", pixels_json(e.other_face)},
            {"displacement",
             {{"pixels", quantiles_json(e.pixels)},
              {"on_part", quantiles_json(e.on_part)},
              {"at_lamps", quantiles_json(e.at_lamps)}}},
            {"normal_arcsec", quantiles_json(e.normal)}};
}

Json bands_json(const FacetBands& bands) {
    Json json{{"places", bands.places}, {"truth", bands.truth}};
    for (const MeshShading shading :
         {MeshShading::constant, MeshShading::gouraud, MeshShading::phong})
        json[std::string(name_of(shading))] = bands.mesh[static_cast<std::size_t>(shading)];
    return json;
}

Json view_json(const MeshErrorReport& report, const MeshErrorView& view) {
    Json meshes = Json::array();
    for (std::size_t m = 0; m < view.meshes.size(); ++m) {
        const MeshErrorPictures& mesh = view.meshes[m];
        meshes.push_back({{"asked", report.meshes[m].asked},
                          {"errors", errors_json(mesh.errors)},
                          {"facet_bands", bands_json(mesh.bands)},
                          {"mirror", mesh.mirror},
                          {"wrong", mesh.wrong},
                          {"close_up", name_or_null(mesh.close_up)}});
    }
    return {{"view", view.name},
            {"width", view.width},
            {"height", view.height},
            {"truth", view.truth},
            {"close_up", name_or_null(view.close_up)},
            {"close_up_side", view.close_up_side},
            {"magnification", view.magnification},
            {"meshes", std::move(meshes)}};
}

} // namespace

std::string mesh_error_json(const MeshErrorReport& report) {
    Json meshes = Json::array(), views = Json::array();
    for (std::size_t m = 0; m < report.meshes.size(); ++m) {
        const ComparedMesh& mesh = report.meshes[m];
        const std::optional<double> share = wrong_share(report, m);
        meshes.push_back({{"asked", mesh.asked},
                          {"deviation", mesh.deviation},
                          {"triangles", mesh.triangles},
                          {"lost_faces", mesh.lost_faces},
                          {"wrong_share", share ? Json(*share) : Json()}});
    }
    for (const MeshErrorView& view : report.views) views.push_back(view_json(report, view));
    return text_of({{"format", "keiko-mesh-error/1"},
                    {"tool", {{"name", "keiko"}, {"version", report.tool_version}}},
                    {"source", report.source},
                    {"lamps", report.lamps},
                    {"normals", report.averaged_normals ? "averaged" : "surface"},
                    {"deviations", report.proved ? "proved" : "measured"},
                    {"wrong_coverage", wrong_coverage},
                    {"reversed_coverage", reversed_coverage},
                    {"meshes", std::move(meshes)},
                    {"views", std::move(views)}});
}

} // namespace keiko
