#include "keiko/report/content/scan_comparison.h"
#include "keiko/report/json/json_parts.h"

namespace keiko {
namespace {

Json optional(const std::optional<double>& value) {
    return value ? Json(*value) : Json();
}

Json place_json(const ScanComparison& c, const DeviationPlace& at) {
    return {{"value", at.value}, {"place", point(at.place)}, {"face", c.faces[at.face]}};
}

/// null where no point is measured.
Json deviation_json(const ScanComparison& c) {
    const ScanDeviation& d = c.deviation;
    if (d.measured == 0) return {};
    return {
        {"mean", d.mean},
        {"root_mean_square", d.root_mean_square},
        {"standard_deviation", d.standard_deviation},
        {"lowest", place_json(c, d.lowest)},
        {"highest", place_json(c, d.highest)},
        {"percentiles",
         {{"50", d.median}, {"90", d.percent_90}, {"99", d.percent_99}, {"99.9", d.percent_99_9}}},
        {"histogram",
         {{"width", d.histogram.width},
          {"lowest", d.histogram.lowest},
          {"counts", d.histogram.counts}}}};
}

Json faces_json(const ScanComparison& c) {
    Json faces = Json::array();
    for (std::size_t f = 0; f < c.faces.size(); ++f) {
        const ScannedFace& face = c.deviation.faces[f];
        Json json = {{"face", c.faces[f]}, {"points", face.points}};
        if (c.limits.tolerance) json["within"] = face.within;
        if (face.points > 0)
            json.update({{"mean", face.mean},
                         {"root_mean_square", face.root_mean_square},
                         {"lowest", face.lowest},
                         {"highest", face.highest}});
        faces.push_back(std::move(json));
    }
    return faces;
}

Json views_json(const ScanComparison& c) {
    Json views = Json::array();
    for (const ScanView& view : c.views)
        views.push_back({{"view", view.name},
                         {"map", view.map},
                         {"width", view.width},
                         {"height", view.height}});
    return views;
}

Json points_json(const std::vector<Vec3>& points) {
    Json json = Json::array();
    for (const Vec3& p : points) json.push_back(point(p));
    return json;
}

Json point_alignment_json(const PointAlignment& a) {
    Json json = alignment_json(a.rigid);
    json["used"] = a.used;
    json["free"] = {{"shifts", points_json(a.free.shifts)}, {"turns", points_json(a.free.turns)}};
    return json;
}

} // namespace

std::string scan_json(const ScanComparison& c) {
    const ScanDeviation& d = c.deviation;
    return text_of({{"format", "keiko-scan/1"},
                    {"tool", {{"name", "keiko"}, {"version", c.tool_version}}},
                    {"verdict", verdict_of(c)},
                    {"nominal", c.nominal},
                    {"scan", c.scan},
                    {"tolerance", optional(c.limits.tolerance)},
                    {"least_share", c.limits.least_share},
                    {"within", optional(d.within)},
                    {"alignment", c.alignment ? point_alignment_json(*c.alignment) : Json()},
                    {"reach", real_json(c.reach)},
                    {"points",
                     {{"all", d.points},
                      {"measured", d.measured},
                      {"beyond", d.beyond},
                      {"beside", d.beside},
                      {"uncertain", d.uncertain}}},
                    {"deviation", deviation_json(c)},
                    {"faces", faces_json(c)},
                    {"map_radius", c.map_radius},
                    {"views", views_json(c)}});
}

} // namespace keiko
