#include "keiko/base/error.h"
#include "keiko/report/json/json_parts.h"
#include "keiko/report/json/placement_json.h"

#include <array>
#include <cmath>

namespace keiko {
namespace {

constexpr const char* format = "keiko-hits/1";
constexpr double widest_fov = 175; ///< degrees

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

/// Calls `read`; its error names `where`, at which a value is missing or of another kind.
template <class Read>
auto part(const std::string& where, const Read& read) {
    try {
        return read();
    } catch (const Json::exception&) {
        throw Error("", where, "a member is missing or not of the right kind");
    } catch (const Error& error) {
        const std::string& key = error.where();
        throw Error("", key.empty() ? where : where + "." + key, error.reason());
    }
}

bool finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void require_camera(const NamedView& view) {
    const Camera& c = view.camera;
    const auto require = [&](bool holds, const char* reason) {
        if (!holds) throw Error("", "", "the camera of '" + shortened(view.name) + "': " + reason);
    };
    require(c.width >= 1 && c.height >= 1, "width and height must be 1 or more");
    require(finite(c.eye) && finite(c.target) && finite(c.up), "a coordinate is not finite");
    const Vec3 ahead = c.target - c.eye;
    require(ahead.length() > 0, "target must differ from eye");
    require(ahead.cross(c.up).length() > 1e-6 * ahead.length() * c.up.length(),
            "up must not be along the view direction");
    if (c.projection == Projection::perspective)
        require(c.vertical_fov > 0 && c.vertical_fov <= widest_fov,
                "vertical_fov must be above 0 and at most 175 degrees");
    else
        require(c.orthographic_height > 0 && std::isfinite(c.orthographic_height),
                "orthographic_height must be above 0");
}

NamedView view_from(const Json& json) {
    NamedView view{json.at("name"), camera_from(json.at("camera"))};
    require_camera(view);
    return view;
}

void require_sample(const ViewSample& s, const Camera& camera) {
    const auto require = [](bool holds, const char* reason) {
        if (!holds) throw Error("", "", reason);
    };
    require(s.edge >= 1, "one stands for no pixel");
    require(
        s.pixel.x >= 0 && s.pixel.x <= camera.width && s.pixel.y >= 0 && s.pixel.y <= camera.height,
        "one is beside its picture");
    require(s.weight > 0 && std::isfinite(s.weight), "one has no solid_angle above 0");
    require(finite(s.mirror.origin), "a place is not finite");
    constexpr double rounding = 1e-6;
    require(std::abs(s.normal.length() - 1) <= rounding, "a normal is not of length 1");
    require(std::abs(s.mirror.direction.length() - 1) <= rounding,
            "a mirrored direction is not of length 1");
}

ViewSample hit_from(const Json& json, const RegisteredHits& hits) {
    if (json.size() != columns().size())
        throw Error("", "hits",
                    "one has " + std::to_string(json.size()) + " numbers instead of " +
                        std::to_string(columns().size()));
    ViewSample s;
    s.view = count_from<std::uint32_t>(json[0]);
    s.instance = count_from<std::uint32_t>(json[1]);
    s.face = count_from<std::uint32_t>(json[2]);
    s.edge = count_from<int>(json[3]);
    s.blocked = json[4];
    if (s.view >= hits.views.size() || s.face >= hits.faces || s.instance >= hits.instances)
        throw Error("", "", "one is of a view or face that is not there");
    std::size_t next = 5;
    RayDifferentials& d = s.mirror.differentials.emplace();
    for_numbers(s, d, [&](double& number) {
        number = real_from(json[next++]);
        if (!std::isfinite(number)) throw Error("", "", "a number is not finite");
    });
    const Camera& camera = hits.views[s.view].camera;
    require_sample(s, camera);
    s.eye = camera.ray(s.pixel.x, s.pixel.y).origin;
    return s;
}

RegisteredHits parsed(const Json& json) {
    if (json.value("format", Json()) != format || json.value("columns", Json()) != columns())
        throw Error("", "format", std::string("is not ") + format);
    RegisteredHits hits;
    part("body", [&] {
        const Json& body = json.at("body");
        hits.faces = count_at<std::size_t>(body, "faces");
        hits.instances = count_at<std::size_t>(body, "instances");
        hits.body = {point_from(body.at("lower")), point_from(body.at("upper"))};
    });
    part("views", [&] {
        for (const Json& view : json.at("views")) hits.views.push_back(view_from(view));
    });
    part("hits", [&] {
        for (const Json& hit : json.at("hits")) hits.samples.push_back(hit_from(hit, hits));
    });
    if (hits.views.empty()) throw Error("", "views", "there is none");
    if (hits.samples.empty()) throw Error("", "hits", "there is none");
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
    } catch (const Json::parse_error& error) {
        throw Error(file, "",
                    "is no file of registered hits: no JSON at byte " + std::to_string(error.byte));
    } catch (const Json::exception&) {
        throw Error(file, "", "is no file of registered hits");
    }
}

} // namespace keiko
