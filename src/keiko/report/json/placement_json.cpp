#include "keiko/report/json/placement_json.h"

#include "keiko/report/markup/json_text.h"

namespace keiko {
namespace {

Json score_json(const PlacementScore& score) {
    return {{"coverage", score.coverage},     {"stripes", score.stripes},
            {"uniformity", score.uniformity}, {"in_range", score.in_range},
            {"crossing", score.crossing},     {"compactness", score.compactness},
            {"objective", score.objective()}};
}

Json plane_json(const PlacedPlane& plane) {
    const CPlane& lamps = plane.lamps;
    return {{"origin", point(lamps.origin)},
            {"u", point(lamps.u)},
            {"v", point(lamps.v)},
            {"lamps", lamps.lamps},
            {"pitch", lamps.spacing()},
            {"diameter", lamps.diameter},
            {"score", score_json(plane.score)}};
}

Json face_json(const FaceCoverage& coverage, const SurfaceModel& model) {
    const Face& face = model.faces[coverage.face];
    return {{"id", face.id},
            {"name", face.name},
            {"instance", coverage.instance},
            {"share", coverage.share},
            {"reached", coverage.reached}};
}

Json region_json(const UnreachedRegion& region, const SurfaceModel& model,
                 std::span<const std::string> views) {
    Json faces = Json::array();
    for (const std::uint32_t face : region.faces) faces.push_back(model.faces[face].id);
    const Box2& pixels = region.pixels;
    return {{"view", views[region.view]},
            {"because", name_of(region.because)},
            {"share", region.share},
            {"place", point(region.place)},
            {"box", {{"lower", point(region.box.lower)}, {"upper", point(region.box.upper)}}},
            {"faces", faces},
            {"pixels", {pixels.lower.x, pixels.lower.y, pixels.upper.x, pixels.upper.y}}};
}

Json candidate_json(const PlaneCandidate& candidate) {
    return {{"towards", point(candidate.towards)},
            {"distance", candidate.distance},
            {"score", score_json(candidate.score)}};
}

template <class Values, class Each>
Json list(const Values& values, const Each& each) {
    Json json = Json::array();
    for (const auto& value : values) json.push_back(each(value));
    return json;
}

} // namespace

std::string placement_json(const Placement& placement, const SurfaceModel& model,
                           std::span<const std::string> views, const std::string& tool_version) {
    const StripeStatistics& stripes = placement.stripes;
    return text_of(
        {{"format", "keiko-placement/1"},
         {"tool", {{"name", "keiko"}, {"version", tool_version}}},
         {"rig", placement.rig.name},
         {"lamp", name_of(placement.kind)},
         {"views", views},
         {"symmetry", placement.mirror ? Json(placement.mirror->text()) : Json()},
         {"coverage", placement.coverage},
         {"blocked", placement.blocked},
         {"stripes",
          {{"narrow", stripes.narrow},
           {"median", stripes.median},
           {"wide", stripes.wide},
           {"in_range", stripes.in_range},
           {"uniformity", stripes.uniformity}}},
         {"planes", list(placement.planes, plane_json)},
         {"faces", list(placement.faces, [&](const auto& face) { return face_json(face, model); })},
         {"unreached", list(placement.unreached,
                            [&](const auto& region) { return region_json(region, model, views); })},
         {"candidates", list(placement.candidates, candidate_json)}});
}

} // namespace keiko
