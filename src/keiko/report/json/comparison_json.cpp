#include "keiko/report/content/comparison.h"
#include "keiko/report/json/json_parts.h"

namespace keiko {
namespace {

Json optional(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json place_json(const DeviationPlace& place, const std::vector<std::string>& faces) {
    return {{"value", real_json(place.value)},
            {"place", point(place.place)},
            {"face", place.face < faces.size() ? Json(faces[place.face]) : Json()}};
}

Json face_json(const FaceDeviation& face, const std::string& name,
               const std::vector<std::string>& others) {
    return {{"face", name},
            {"partner", face.partner == no_index ? Json() : Json(others[face.partner])},
            {"area", face.area},
            {"worst", real_json(face.worst.value)},
            {"place", point(face.worst.place)},
            {"root_mean_square", face.beyond < 1 ? Json(face.root_mean_square) : Json()},
            {"beyond", face.beyond},
            {"beside", face.beside},
            {"turned", face.turned},
            {"alone", face.alone()}};
}

Json deviation_json(const Deviation& d, const std::vector<std::string>& faces,
                    const std::vector<std::string>& others) {
    const auto near = [&](double value) { return d.beyond < 1 ? Json(value) : Json(); };
    Json json = {{"samples", d.samples},
                 {"area", d.area},
                 {"reach", real_json(d.reach)},
                 {"beyond", d.beyond},
                 {"mean", near(d.mean)},
                 {"root_mean_square", near(d.root_mean_square)},
                 {"lowest", near(d.lowest)},
                 {"highest", near(d.highest)},
                 {"percentiles",
                  {{"50", real_json(d.median)},
                   {"90", real_json(d.percent_90)},
                   {"99", real_json(d.percent_99)},
                   {"99.9", real_json(d.percent_99_9)}}},
                 {"worst", place_json(d.worst, faces)},
                 {"normal", place_json(d.worst_normal, faces)},
                 {"border", place_json(d.worst_border, faces)},
                 {"claimed_border", d.claimed_border},
                 {"uncertain_share", d.uncertain_share},
                 {"largest_uncertainty", d.largest_uncertainty},
                 {"faces", Json::array()}};
    for (std::size_t f = 0; f < d.faces.size(); ++f)
        json["faces"].push_back(face_json(d.faces[f], faces[f], others));
    return json;
}

Json state_json(const SeamState& state) {
    return {{"gap", state.gap},
            {"angle", optional(state.angle)},
            {"curvature", optional(state.curvature)},
            {"verdict", name_of(state.verdict)},
            {"severity", state.severity},
            {"place", point(state.place)}};
}

Json names_json(const Inspection& inspection, const std::vector<std::uint32_t>& seams) {
    Json names = Json::array();
    for (const std::uint32_t seam : seams) names.push_back(inspection.seams[seam].faces);
    return names;
}

Json seams_json(const Comparison& c) {
    Json json = {{"matched", c.seams.matched},
                 {"changed", Json::array()},
                 {"gone", names_json(c.inspection_before, c.seams.removed)},
                 {"new", names_json(c.inspection_after, c.seams.added)}};
    for (const SeamChange& change : c.seams.changed)
        json["changed"].push_back(
            {{"trend", name_of(change.trend)},
             {"faces_before", names_json(c.inspection_before, change.seams.before)},
             {"faces_after", names_json(c.inspection_after, change.seams.after)},
             {"before", state_json(change.before)},
             {"after", state_json(change.after)}});
    return json;
}

Json findings_json(const std::vector<Check>& findings) {
    Json json = Json::array();
    for (const Check& finding : findings)
        json.push_back({{"code", finding.code},
                        {"quantity", finding.quantity},
                        {"faces", finding.faces},
                        {"value", finding.worst.value},
                        {"limit", finding.worst.limit},
                        {"unit", finding.unit},
                        {"verdict", name_of(finding.worst.verdict)},
                        {"place", point(finding.worst.place)},
                        {"message", finding.message}});
    return json;
}

Json lines_json(const std::vector<LineShift>& lines) {
    Json json = Json::array();
    for (const LineShift& line : lines)
        json.push_back({{"plane", line.plane},
                        {"lamp", line.lamp},
                        {"length", line.length},
                        {"alone", line.alone},
                        {"mean", line.mean},
                        {"largest", line.largest},
                        {"place", point(line.place)}});
    return json;
}

Json outlines_json(const OutlineDifference& outlines) {
    return {{"within", outlines.within()},
            {"excused", outlines.excused},
            {"moved", outlines.moved},
            {"alike", outlines.alike},
            {"distance", real_json(outlines.worst.distance)},
            {"pixels", real_json(outlines.worst.pixels)},
            {"excess", real_json(outlines.worst.excess)},
            {"place", point(outlines.worst.place)},
            {"x", outlines.x},
            {"y", outlines.y}};
}

Json view_json(const ComparedView& view, const BodyTolerance& tolerance) {
    Json json = picture_outcome_json(view.picture);
    json["outlines"] = outlines_json(view.outlines);
    json["map"] = view.map;
    json["lines_within"] = lines_within(view, tolerance);
    json["lines"] = lines_json(view.lines);
    json["after_lines"] = lines_json(view.after_lines);
    return json;
}

Json tolerance_json(const BodyTolerance& tolerance) {
    return {{"deviation", tolerance.deviation}, {"border", tolerance.border},
            {"normal", tolerance.normal},       {"line", tolerance.line},
            {"outline", tolerance.outline},     {"outline_pixels", tolerance.outline_pixels}};
}

Json faces_json(const Comparison& c) {
    return {{"before", c.faces_before.size()},
            {"after", c.faces_after.size()},
            {"gone", faces_gone(c)},
            {"new", faces_new(c)},
            {"turned", faces_turned(c)}};
}

Json checks_json(const Comparison& c) {
    Json json = Json::array();
    for (const ComparisonCheck& check : comparison_checks(c))
        json.push_back({{"name", check.name},
                        {"within", check.within},
                        {"judged", check.judged},
                        {"message", check.message}});
    return json;
}

} // namespace

std::string comparison_json(const Comparison& c) {
    Json json = {{"format", "keiko-comparison/1"},
                 {"tool", {{"name", "keiko"}, {"version", c.tool_version}}},
                 {"verdict", c.same() ? "same" : "different"},
                 {"before", c.before},
                 {"after", c.after},
                 {"tolerance", tolerance_json(c.tolerance)},
                 {"preset", c.inspection_after.preset.name},
                 {"alignment", c.alignment ? alignment_json(*c.alignment) : Json()},
                 {"checks", checks_json(c)},
                 {"deviation", deviation_json(c.deviation, c.faces_after, c.faces_before)},
                 {"missing", deviation_json(c.missing, c.faces_before, c.faces_after)},
                 {"faces", faces_json(c)},
                 {"seams", seams_json(c)},
                 {"findings",
                  {{"new", findings_json(c.seams.new_findings)},
                   {"fixed", findings_json(c.seams.solved_findings)},
                   {"same", findings_json(c.seams.same_findings)}}},
                 {"rig", c.rig},
                 {"views", Json::array()}};
    const auto& before = c.inspection_before.scope;
    const auto& after = c.inspection_after.scope;
    if (before && after)
        json["scope"] = {{"before", scope_json(*before, c.inspection_before.preset)},
                         {"after", scope_json(*after, c.inspection_after.preset)}};
    for (const ComparedView& view : c.views) json["views"].push_back(view_json(view, c.tolerance));
    return text_of(json);
}

} // namespace keiko
