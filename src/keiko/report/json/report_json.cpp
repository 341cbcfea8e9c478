#include "keiko/inspect/seams/curvature_match.h"
#include "keiko/report/content/inspection_texts.h"
#include "keiko/report/content/report.h"
#include "keiko/report/json/json_parts.h"

namespace keiko {
namespace {

Json curvature(const CurvatureStep& step) {
    Json json = measured_json(step.worst);
    json["unit"] = "1";
    json["flat"] = step.flat;
    json["formula"] = name_of(step.formula);
    json["formula_text"] = formula_text(step.formula);
    json["mismatch"] = step.mismatch;
    json["alias"] = step.alias;
    json["catia"] = step.catia;
    json["curvatures"] = {step.curvature_a, step.curvature_b};
    return json;
}

Json slope(const CurvatureSlopeStep& step) {
    Json json = measured_json(step.worst);
    json["unit"] = "deg";
    json["change"] = step.change;
    json["slopes"] = {step.slope_a, step.slope_b};
    return json;
}

/// A value that was not compared with a limit.
Json without_verdict(Json json) {
    json["limit"] = Json(), json["verdict"] = Json();
    return json;
}

/// Name of the zone of a face, or null.
Json zone_json(const Inspection& inspection, const PlacedFace& face) {
    const std::uint32_t zone = inspection.limits.zone_of(face);
    return zone == no_zone ? Json() : Json(inspection.preset.zones.at(zone).name);
}

/// The points of each piece of a stretch.
Json course_json(const MeasuredSeam& seam) {
    Json pieces = Json::array();
    for (const std::vector<Vec3>& piece : seam.course) {
        Json points = Json::array();
        for (const Vec3& p : piece) points.push_back(point(p));
        pieces.push_back(std::move(points));
    }
    return pieces;
}

Json seam_json(const MeasuredSeam& seam, std::size_t number, const Inspection& inspection) {
    const CriteriaPreset& preset = limits_of(inspection, seam);
    Json json = {{"number", number},
                 {"line", seam.line + 1},
                 {"faces", seam.faces},
                 {"face_ids", {seam.id_a, seam.id_b}},
                 {"instances", {seam.instance_a, seam.instance_b}},
                 {"verdict", name_of(seam.verdict)},
                 {"kind", name_of(seam.kind)},
                 {"scrap", seam.scrap},
                 {"irregular", seam.irregular},
                 {"internal", seam.internal},
                 {"overlap", seam.overlap},
                 {"parted", seam.parted},
                 {"severity", seam.severity},
                 {"length", seam.length},
                 {"middle", point(seam.middle)},
                 {"from", point(seam.course.front().front())},
                 {"to", point(seam.course.back().back())},
                 {"course", course_json(seam)},
                 {"gap", Json()}};
    const auto judged = [](Json value, bool is_judged) {
        return is_judged || value.is_null() ? value : without_verdict(std::move(value));
    };
    json["gap"] = judged(measured_json(seam.gap), !seam.scrap);
    json["angle"] =
        judged(seam.angle ? measured_json(*seam.angle) : Json(), seam.is_angle_judged());
    if (seam.angle) json["angle"]["smallest"] = seam.smallest_angle;
    json["curvature"] = judged(seam.curvature ? curvature(*seam.curvature) : Json(),
                               preset.curvature.has_value() && !seam.scrap);
    json["curvature_slope"] = judged(seam.slope ? slope(*seam.slope) : Json(),
                                     preset.curvature_slope.has_value() && !seam.scrap);
    json["fading"] = judged(seam.fading ? measured_json(*seam.fading) : Json(), !seam.scrap);
    if (!inspection.preset.zones.empty())
        json["zones"] = {zone_json(inspection, seam.side_a()),
                         zone_json(inspection, seam.side_b())};
    return json;
}

Json extreme(const CurvatureExtreme& e) {
    return {{"value", e.value},
            {"bound", e.bound},
            {"undecided", e.undecided},
            {"place", point(e.place)}};
}

Json curvature(const FaceCurvature& c) {
    return {{"largest", extreme(c.largest)},
            {"smallest", extreme(c.smallest)},
            {"largest_mean", extreme(c.largest_mean)},
            {"smallest_mean", extreme(c.smallest_mean)},
            {"largest_gaussian", extreme(c.largest_gaussian)},
            {"smallest_gaussian", extreme(c.smallest_gaussian)},
            {"singular", c.singular}};
}

std::string_view name_of(Flaw::Kind kind) {
    switch (kind) {
        case Flaw::Kind::dent:
            return "dent";
        case Flaw::Kind::bump:
            return "bump";
        case Flaw::Kind::waves:
            return "waves";
        case Flaw::Kind::unsearched:
        case Flaw::Kind::rough:
            return "unsearched";
    }
    return "";
}

Json flaw_json(const Flaw& flaw) {
    Json json = {{"kind", name_of(flaw.kind)}, {"width", flaw.width}, {"window", flaw.window}};
    json.update(measured_json(flaw.depth));
    return json;
}

Json inflection_json(const InflectionCurve& curve) {
    Json points = Json::array();
    for (const Vec3& p : curve.points) points.push_back(point(p));
    return {{"closed", curve.closed},       {"proved", curve.proved},
            {"length", curve.length},       {"rate", curve.rate},
            {"deviation", curve.deviation}, {"points", std::move(points)}};
}

Json face_json(const MeasuredFace& face, std::size_t number, const Inspection& inspection) {
    const CriteriaPreset& preset = limits_of(inspection, face);
    const SurfaceLimits& limits = preset.surface;
    Json json = {{"number", number},
                 {"name", face.name},
                 {"face_id", face.id},
                 {"instance", face.instance},
                 {"verdict", name_of(face.verdict)},
                 {"radius", Json()},
                 {"curvature", face.curvature ? curvature(*face.curvature) : Json()}};
    if (face.radius)
        json["radius"] = limits.minimum_radius ? measured_json(*face.radius)
                                               : without_verdict(measured_json(*face.radius));
    if (face.draft) json["draft"] = measured_json(*face.draft);
    json["inflections"] = Json::array();
    for (const InflectionCurve& curve : face.inflections)
        json["inflections"].push_back(inflection_json(curve));
    if (!preset.flaw_limits().empty()) {
        json["flaws"] = Json::array();
        for (const Flaw& flaw : face.flaws) json["flaws"].push_back(flaw_json(flaw));
    }
    if (!inspection.preset.zones.empty())
        json["zone"] = zone_json(inspection, {face.instance, face.face});
    if (inspection.scope) json["in_scope"] = face.in_scope;
    if (!face.in_scope) json["verdict"] = Json();
    return json;
}

/// Seams are numbered from 1, in JSON as in tables.
std::vector<std::uint32_t> numbers_of(std::vector<std::uint32_t> indices) {
    for (std::uint32_t& index : indices) ++index;
    return indices;
}

Json inspection_json_value(const Inspection& inspection) {
    const SeamCounts& counts = inspection.counts;
    const FaceCounts& faces = inspection.face_counts;
    Json json = {{"verdict", name_of(inspection.verdict)},
                 {"counts",
                  {{"fail", counts.fail},
                   {"undecided", counts.undecided},
                   {"pass", counts.pass},
                   {"creases", counts.creases},
                   {"run_outs", counts.run_outs},
                   {"scraps", counts.scraps},
                   {"accepted", counts.accepted}}},
                 {"face_counts",
                  {{"fail", faces.fail},
                   {"undecided", faces.undecided},
                   {"pass", faces.pass},
                   {"accepted", faces.accepted}}},
                 {"preset", preset_json(inspection.preset)},
                 {"join", inspection.join},
                 {"model", model_json(inspection.facts)},
                 {"worst_seams", numbers_of(worst_seams(inspection, worst_seam_count))},
                 {"seams", Json::array()},
                 {"faces", Json::array()},
                 {"findings", findings_json(inspection)},
                 {"accepted", accepted_json(inspection)},
                 {"acceptance_remarks", acceptance_remarks_json(inspection)}};
    for (std::size_t i = 0; i < inspection.seams.size(); ++i)
        json["seams"].push_back(seam_json(inspection.seams[i], i + 1, inspection));
    for (std::size_t i = 0; i < inspection.faces.size(); ++i)
        json["faces"].push_back(face_json(inspection.faces[i], i + 1, inspection));
    for (const Check& check : inspection.checks)
        if (check.code == "KEIKO-SYMMETRY") json["symmetry"] = finding_json(check);
    if (inspection.scope) json["scope"] = scope_json(*inspection.scope, inspection.preset);
    if (inspection.joints) {
        json["preset"]["joint"] = joint_limits_json(inspection.preset.joint);
        json["joints"] = joints_json(*inspection.joints);
    }
    return json;
}

Json picture_json(const ReportPicture& picture) {
    Json markers = Json::array();
    for (const PictureMarker& m : picture.markers)
        markers.push_back({{"number", m.number}, {"x", m.x}, {"y", m.y}});
    return {{"title", picture.title},
            {"file", picture.file_name},
            {"width", picture.width},
            {"height", picture.height},
            {"markers", markers}};
}

Json pictures_json(const std::vector<ReportPicture>& pictures) {
    Json json = Json::array();
    for (const ReportPicture& picture : pictures) json.push_back(picture_json(picture));
    return json;
}

const char* word_of(CloseUp::Of of) {
    return of == CloseUp::Of::seam ? "seam" : of == CloseUp::Of::face ? "face" : "crossing";
}

Json note_json(const AnalysisNote& note) {
    return {{"text", note.text},
            {"place", {note.place.x, note.place.y, note.place.z}},
            {"face", note.face > 0 ? Json(note.face) : Json()}};
}

Json coverage_json(const CoverageSummary& coverage) {
    return {
        {"rig", coverage.rig}, {"covered", coverage.covered}, {"unreached", coverage.unreached}};
}

} // namespace

std::string report_json(const Report& report) {
    Json json = {{"format", "keiko-report/1"},
                 {"tool", {{"name", "keiko"}, {"version", report.tool_version}}},
                 {"inputs", Json::array()},
                 {"opened", report.opened},
                 {"views", Json::array()}};
    for (const InputFile& input : report.inputs)
        json["inputs"].push_back({{"path", input.path}, {"sha256", input.sha256}});
    for (const NamedView& view : report.views)
        json["views"].push_back({{"name", view.name}, {"camera", camera_json(view.camera)}});
    json.update(inspection_json_value(whole_inspection(report)));
    json["verdict"] = name_of(verdict_of(report));
    json["lines"] = report.lines ? line_verdicts_json(*report.lines) : Json();
    json["triage"] = triage_json(report.triage);
    json["coverage"] = report.coverage ? coverage_json(*report.coverage) : Json();
    json["notes"] = Json::array();
    for (const AnalysisNote& note : report.notes) json["notes"].push_back(note_json(note));
    json["standing_pictures"] = pictures_json(report.standing_pictures);
    json["pictures"] = pictures_json(report.pictures);
    json["line_pictures"] = pictures_json(report.line_pictures);
    json["curvature_pictures"] = pictures_json(report.curvature_pictures);
    json["close_ups"] = Json::array();
    for (const CloseUp& close_up : report.close_ups) {
        json["close_ups"].push_back(picture_json(close_up.picture));
        json["close_ups"].back()[word_of(close_up.of)] = close_up.index + 1;
    }
    return text_of(json);
}

std::string inspection_json(const Inspection& inspection, const std::string& tool_version) {
    Json json = {{"format", "keiko-inspection/1"},
                 {"tool", {{"name", "keiko"}, {"version", tool_version}}}};
    json.update(inspection_json_value(inspection));
    return text_of(json);
}

} // namespace keiko
