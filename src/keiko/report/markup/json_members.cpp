#include "keiko/report/markup/json_members.h"

#include <algorithm>
#include <cmath>

namespace keiko {

void require(bool holds, const std::string& key, const std::string& reason) {
    if (!holds) throw Error("", key, reason);
}

void require_known_keys(const Json& json, std::initializer_list<const char*> known) {
    require(json.is_object(), "", "is no object");
    for (const auto& [key, value] : json.items())
        require(std::find(known.begin(), known.end(), key) != known.end(), "",
                "unknown key " + in_quotes(key));
}

const Json& value_at(const Json& json, const char* key) {
    const auto found = json.find(key);
    require(found != json.end(), key, "is missing");
    return *found;
}

std::string text_at(const Json& json, const char* key, bool optional) {
    if (optional && !json.contains(key)) return "";
    const Json& value = value_at(json, key);
    require(value.is_string(), key, "is no text");
    std::string text = value.get<std::string>();
    require(!text.empty(), key, "is empty");
    return text;
}

Vec3 place_at(const Json& json, const char* key) {
    const Json& value = value_at(json, key);
    const bool is_point =
        value.is_array() && value.size() == 3 &&
        std::all_of(value.begin(), value.end(), [](const Json& x) { return x.is_number(); });
    require(is_point, key, "is no place [x, y, z]");
    const Vec3 place = point_from(value);
    require(std::isfinite(place.length()), key, "is not finite");
    return place;
}

Json list_at(const Json& json, const char* key) {
    if (!json.contains(key)) return Json::array();
    require(json.at(key).is_array(), key, "is no array");
    return json.at(key);
}

} // namespace keiko
