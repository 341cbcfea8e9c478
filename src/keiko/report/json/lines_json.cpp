#include "keiko/report/content/line_list.h"
#include "keiko/report/json/json_parts.h"

namespace keiko {
namespace {

Json optional(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json viewpoint_json(const Camera& camera) {
    const bool perspective = camera.projection == Projection::perspective;
    return {{"projection", perspective ? "perspective" : "orthographic"},
            {"eye", point(camera.eye)},
            {"target", point(camera.target)}};
}

/// The straight lines of light of one source, from end to end.
Json source_json(const LineSource& source) {
    Json lines = Json::array();
    for (int lamp = 0; lamp < source.row.lamps; ++lamp) {
        const Segment line = source.line(lamp);
        lines.push_back({point(line.a), point(line.b)});
    }
    return {{"kind", source.of_panels ? "edges" : "tubes"}, {"lamps", std::move(lines)}};
}

Json piece_json(const SurfaceLine& piece, const SurfaceModel& model) {
    Json points = Json::array();
    for (const LinePoint& p : piece.line.points) points.push_back(point(p.place));
    return {{"face", model.faces[piece.face].id},
            {"instance", piece.instance},
            {"patch", piece.patch - model.faces[piece.face].first_patch},
            {"proved", piece.line.proved},
            {"length", length_of(piece.line)},
            {"deviation", piece.line.deviation},
            {"points", points}};
}

Json shape_json(const LineStatistics& shape) {
    return {{"length", shape.length},
            {"turning", shape.turning},
            {"waviness", shape.waviness},
            {"inflections", shape.inflections.size()},
            {"largest_bend", shape.largest_bend},
            {"spacing", {shape.least_spacing, shape.most_spacing}},
            {"spacing_ratio", shape.spacing_ratio},
            {"spacing_rate", shape.spacing_rate}};
}

Json line_json(const JoinedLine& line, const ViewLines& view, const SurfaceModel& model) {
    Json json = {{"view", view.view},        {"plane", line.plane},
                 {"lamp", line.lamp},        {"begin", name_of(line.begin)},
                 {"end", name_of(line.end)}, {"length", line.length},
                 {"shapes", Json::array()},  {"inflections", Json::array()},
                 {"pieces", Json::array()}};
    for (const LineStatistics& shape : line.shapes) json["shapes"].push_back(shape_json(shape));
    for (const LineInflection& turn : line.inflections)
        json["inflections"].push_back({{"along", turn.along}, {"place", point(turn.place)}});
    for (const std::uint32_t piece : line.pieces)
        json["pieces"].push_back(piece_json(view.found.pieces[piece], model));
    return json;
}

Json value_json(const LineValue& value) {
    return {{"value", value.value},
            {"bound", value.bound},
            {"limit", optional(value.limit)},
            {"verdict", value.limit ? Json(name_of(value.verdict)) : Json()}};
}

Json crossing_json(const LineCrossing& crossing, const std::string& view, std::size_t first_line) {
    Json json = {{"view", view},
                 {"line", first_line + crossing.line},
                 {"plane", crossing.plane},
                 {"lamp", crossing.lamp},
                 {"faces", crossing.faces},
                 {"inside_face", crossing.border.seam == no_index},
                 {"run_out", crossing.run_out},
                 {"continued", crossing.continued()},
                 {"verdict", crossing.verdict ? Json(name_of(*crossing.verdict)) : Json()},
                 {"severity", crossing.severity},
                 {"place", point(crossing.place)},
                 {"gap", crossing.gap},
                 {"angle", crossing.angle},
                 {"plane_jump", crossing.plane_jump},
                 {"turn", value_json(crossing.turn)}};
    if (!crossing.continued()) return json;
    json["jump"] = value_json(crossing.jump);
    json["kink"] = value_json(crossing.kink);
    json["bend"] = value_json(crossing.bend);
    return json;
}

Json line_limits_json(const CriteriaPreset& preset) {
    return {{"name", preset.name},
            {"jump", optional(preset.lines.jump)},
            {"turn", optional(preset.lines.turn)},
            {"kink", optional(preset.lines.kink)},
            {"bend", optional(preset.lines.bend)},
            {"feature_angle", preset.feature_angle}};
}

Json counts_json(const LineList& list) {
    const CrossingCounts counts = count_crossings(list);
    Json json = {{"fail", counts.fail},
                 {"undecided", counts.undecided},
                 {"pass", counts.pass},
                 {"not_judged", counts.not_judged}};
    if (list.scope) json["out_of_scope"] = counts.out_of_scope;
    return json;
}

Json crossings_json(const LineList& list) {
    Json json = Json::array();
    std::size_t first_line = 0;
    for (const ViewLines& view : list.views) {
        for (const LineCrossing& crossing : view.found.crossings)
            json.push_back(crossing_json(crossing, view.view, first_line));
        first_line += view.found.lines.size();
    }
    return json;
}

} // namespace

Json line_verdicts_json(const LineList& list) {
    return {{"rig", list.rig},
            {"look", name_of(list.look)},
            {"preset", line_limits_json(list.preset)},
            {"verdict", name_of(verdict_of(list))},
            {"counts", counts_json(list)},
            {"crossings", crossings_json(list)}};
}

std::string lines_json(const LineList& list, const SurfaceModel& model) {
    Json json = {{"format", "keiko-lines/2"},
                 {"tool", {{"name", "keiko"}, {"version", list.tool_version}}},
                 {"model", model.source},
                 {"rig", list.rig},
                 {"look", name_of(list.look)},
                 {"preset", line_limits_json(list.preset)},
                 {"join", list.join},
                 {"verdict", name_of(verdict_of(list))},
                 {"counts", counts_json(list)},
                 {"planes", Json::array()},
                 {"views", Json::array()},
                 {"crossings", crossings_json(list)},
                 {"lines", Json::array()}};
    if (list.scope) json["scope"] = scope_json(*list.scope, list.preset);
    for (const LineSource& source : list.sources) json["planes"].push_back(source_json(source));
    for (const ViewLines& view : list.views) {
        Json camera = {{"name", view.view}};
        camera.update(viewpoint_json(view.camera));
        json["views"].push_back(std::move(camera));
        for (const JoinedLine& line : view.found.lines)
            json["lines"].push_back(line_json(line, view, model));
    }
    constexpr int one_line = -1;
    return json.dump(one_line, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace keiko
