#include "keiko/report/content/combs_text.h"
#include "keiko/report/markup/json_text.h"

namespace keiko {
namespace {

std::string_view name_of(CombCurve::Kind kind) {
    return kind == CombCurve::Kind::section ? "section"
           : kind == CombCurve::Kind::iso_u ? "iso_u"
                                            : "iso_v";
}

Json piece_json(const CombPiece& piece, const SurfaceModel& model) {
    Json samples = Json::array();
    for (const CombSample& s : piece.samples)
        samples.push_back({{"along", s.along},
                           {"place", point(s.place)},
                           {"curvature", s.bend.curvature},
                           {"normal_curvature", s.bend.normal_curvature},
                           {"towards", point(s.bend.towards)}});
    return {{"face", model.faces[piece.face].id},
            {"instance", piece.instance},
            {"patch", piece.patch - model.faces[piece.face].first_patch},
            {"touching", piece.touching},
            {"samples", std::move(samples)}};
}

Json curve_json(const CombCurve& curve, const SurfaceModel& model) {
    const CombSample& most = most_bent(curve);
    Json json = {
        {"kind", name_of(curve.kind)},
        {"name", curve.name},
        {"closed", curve.closed},
        {"length", curve.length},
        {"largest_curvature", {{"value", most.bend.curvature}, {"place", point(most.place)}}},
        {"inflections", Json::array()},
        {"pieces", Json::array()}};
    for (const Vec3& place : inflections_of(curve)) json["inflections"].push_back(point(place));
    for (const CombPiece& piece : curve.pieces) json["pieces"].push_back(piece_json(piece, model));
    return json;
}

Json remark_json(const SectionRemark& remark, std::span<const SectionPlane> planes,
                 const SurfaceModel& model) {
    using Kind = SectionRemark::Kind;
    const std::string& plane = planes[remark.plane].name;
    if (remark.kind == Kind::missed)
        return {{"plane", plane}, {"kind", "missed"}, {"body", remark.reach}};
    Json json = {{"plane", plane},
                 {"kind", remark.kind == Kind::within ? "within" : "touches"},
                 {"face", model.faces[remark.face].id},
                 {"instance", remark.instance}};
    if (remark.kind == Kind::touches) json["place"] = point(remark.place);
    return json;
}

} // namespace

std::string combs_json(const FoundCombs& combs, std::span<const SectionPlane> planes,
                       const SurfaceModel& model, const std::string& tool_version) {
    Json json = {{"format", "keiko-combs/1"},
                 {"tool", {{"name", "keiko"}, {"version", tool_version}}},
                 {"model", model.source},
                 {"curves", Json::array()},
                 {"remarks", Json::array()}};
    for (const CombCurve& curve : combs.curves) json["curves"].push_back(curve_json(curve, model));
    for (const SectionRemark& remark : combs.remarks)
        json["remarks"].push_back(remark_json(remark, planes, model));
    constexpr int one_line = -1;
    return json.dump(one_line, ' ', false, Json::error_handler_t::replace) + "\n";
}

} // namespace keiko
