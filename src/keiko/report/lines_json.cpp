#include "keiko/report/lines_json.h"

#include "keiko/report/json_text.h"

namespace keiko {
namespace {

Json camera_json(const Camera& camera) {
    const bool perspective = camera.projection == Projection::perspective;
    return {{"projection", perspective ? "perspective" : "orthographic"},
            {"eye", point(camera.eye)},
            {"target", point(camera.target)}};
}

Json line_json(const SurfaceLine& line, const std::string& view, const SurfaceModel& model) {
    Json points = Json::array();
    for (const LinePoint& p : line.line.points) points.push_back(point(p.place));
    return {{"view", view},
            {"plane", line.plane},
            {"lamp", line.lamp},
            {"face", model.faces[line.face].id},
            {"instance", line.instance},
            {"patch", line.patch - model.faces[line.face].first_patch},
            {"closed", line.line.closed},
            {"proved", line.line.proved},
            {"length", length_of(line.line)},
            {"deviation", line.line.deviation},
            {"points", points}};
}

} // namespace

std::string lines_json(const LineList& list, const SurfaceModel& model) {
    Json json = {
        {"format", "keiko-lines/1"},  {"tool", {{"name", "keiko"}, {"version", list.tool_version}}},
        {"model", model.source},      {"rig", list.rig},
        {"look", name_of(list.look)}, {"views", Json::array()},
        {"lines", Json::array()}};
    for (const ViewLines& view : list.views) {
        Json camera = {{"name", view.view}};
        camera.update(camera_json(view.camera));
        json["views"].push_back(std::move(camera));
        for (const SurfaceLine& line : view.lines)
            json["lines"].push_back(line_json(line, view.view, model));
    }
    constexpr int one_line = -1;
    return json.dump(one_line, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace keiko
