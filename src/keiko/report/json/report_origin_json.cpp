#include "keiko/report/content/report_origin.h"
#include "keiko/report/json/json_parts.h"
#include "keiko/report/markup/json_errors.h"

namespace keiko {
namespace {

Json parsed(const std::string& text, const char* format) {
    Json json = Json::parse(text);
    if (!json.is_object() || !json.contains("format") || json["format"] != format)
        throw Error("", "", std::string("is not of the format ") + format);
    return json;
}

ReportOrigin origin_from(const Json& json) {
    ReportOrigin origin;
    for (const Json& input : json.at("inputs"))
        origin.inputs.push_back({input.at("path"), input.at("sha256")});
    origin.opened = json.at("opened").get<std::vector<std::string>>();
    for (const Json& view : json.at("views"))
        origin.views.push_back({view.at("name"), checked_camera_from(view.at("camera")), 0});
    if (origin.opened.empty()) throw Error("", "opened", "names no model");
    if (origin.views.empty()) throw Error("", "views", "has no view");
    return origin;
}

} // namespace

ReportOrigin report_origin_from_json(const std::string& text, const std::string& file) {
    return with_errors_named(file, "", [&] { return origin_from(parsed(text, "keiko-report/1")); });
}

void require_faults_json(const std::string& text, const std::string& file) {
    const Json json = with_errors_named(file, "", [&] { return parsed(text, "keiko-faults/1"); });
    for (const char* kind : {"items", "hidden"})
        with_errors_named(file, kind, [&] {
            for (const Json& fault : json.at(kind)) point_from(fault.at("place"));
        });
}

} // namespace keiko
