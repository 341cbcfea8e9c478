#include "keiko/report/hits_json.h"

#include "keiko/base/error.h"
#include "keiko/report/camera_json.h"

#include <array>

namespace keiko {
namespace {

constexpr const char* format = "keiko-hits/1";

/// Calls `visit` with each number of a hit, in the order of the columns.
template <class Sample, class Differentials, class Visit>
void for_numbers(Sample& s, Differentials& d, const Visit& visit) {
    const auto vector = [&](auto& v, unsigned count) {
        for (unsigned k = 0; k < count; ++k) visit(v[k]);
    };
    vector(s.pixel, 2);
    visit(s.weight);
    vector(s.normal, 3);
    vector(s.mirror.origin, 3);
    vector(s.mirror.direction, 3);
    vector(d.origin_dx, 3);
    vector(d.origin_dy, 3);
    vector(d.direction_dx, 3);
    vector(d.direction_dy, 3);
    vector(s.feature.along, 2);
    visit(s.feature.strength);
}

const Json& columns() {
    static const Json names = {
        "view",  "instance", "face",  "pixels", "blocked", "x",       "y",       "solid_angle",
        "nx",    "ny",       "nz",    "px",     "py",      "pz",      "mx",      "my",
        "mz",    "px_dx",    "py_dx", "pz_dx",  "px_dy",   "py_dy",   "pz_dy",   "mx_dx",
        "my_dx", "mz_dx",    "mx_dy", "my_dy",  "mz_dy",   "along_x", "along_y", "strength"};
    return names;
}

Json hit_json(const ViewSample& s) {
    Json json = {s.view, s.instance, s.face, s.edge, s.blocked};
    const RayDifferentials d = s.mirror.differentials.value_or(RayDifferentials{});
    for_numbers(s, d, [&](double number) { json.push_back(real_json(number)); });
    return json;
}

ViewSample hit_from(const Json& json, const RegisteredHits& hits) {
    if (json.size() != columns().size())
        throw Error("", "hits",
                    "one has " + std::to_string(json.size()) + " numbers instead of " +
                        std::to_string(columns().size()));
    ViewSample s;
    s.view = json[0];
    s.instance = json[1];
    s.face = json[2];
    s.edge = json[3];
    s.blocked = json[4];
    if (s.view >= hits.views.size() || s.face >= hits.faces || s.instance >= hits.instances)
        throw Error("", "hits", "one is of a view or face that is not there");
    std::size_t next = 5;
    RayDifferentials& d = s.mirror.differentials.emplace();
    for_numbers(s, d, [&](double& number) { number = real_from(json[next++]); });
    s.eye = hits.views[s.view].camera.ray(s.pixel.x, s.pixel.y).origin;
    return s;
}

RegisteredHits parsed(const Json& json) {
    if (json.at("format") != format || json.at("columns") != columns())
        throw Error("", "format", std::string("is not ") + format);
    RegisteredHits hits;
    const Json& body = json.at("body");
    hits.faces = body.at("faces");
    hits.instances = body.at("instances");
    hits.body = {point_from(body.at("lower")), point_from(body.at("upper"))};
    for (const Json& view : json.at("views"))
        hits.views.push_back({view.at("name"), camera_from(view.at("camera"))});
    for (const Json& hit : json.at("hits")) hits.samples.push_back(hit_from(hit, hits));
    if (hits.views.empty()) throw Error("", "views", "there is none");
    return hits;
}

} // namespace

std::string hits_json(const RegisteredHits& hits, const std::string& tool_version) {
    Json views = Json::array();
    for (const NamedView& view : hits.views)
        views.push_back({{"name", view.name}, {"camera", camera_json(view.camera)}});
    const Json head = {{"format", format},
                       {"tool", {{"name", "keiko"}, {"version", tool_version}}},
                       {"body",
                        {{"faces", hits.faces},
                         {"instances", hits.instances},
                         {"lower", point(hits.body.lower)},
                         {"upper", point(hits.body.upper)}}},
                       {"views", views},
                       {"columns", columns()}};
    // One hit a line: there are tens of thousands.
    std::string text = head.dump(-1, ' ', false, Json::error_handler_t::replace);
    text.pop_back();
    text += ",\n\"hits\": [";
    for (const ViewSample& s : hits.samples) {
        if (&s != &hits.samples.front()) text += ',';
        text += '\n' + hit_json(s).dump();
    }
    return text + "\n]}\n";
}

RegisteredHits hits_from_json(const std::string& text, const std::string& file) {
    try {
        return parsed(Json::parse(text));
    } catch (const Error& error) {
        throw Error(file, error.where(), error.reason());
    } catch (const std::exception& error) { // of the JSON library, and of stod
        throw Error(file, "", std::string("is no file of registered hits: ") + error.what());
    }
}

} // namespace keiko
