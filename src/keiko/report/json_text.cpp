#include "keiko/report/json_text.h"

#include <array>
#include <cmath>
#include <limits>

namespace keiko {

std::string text_of(const Json& json) {
    return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json real_json(double value) {
    if (std::isfinite(value)) return value;
    return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

Json point(const Vec3& p) {
    return {p.x, p.y, p.z};
}

Vec3 point_from(const Json& json) {
    const auto p = json.get<std::array<double, 3>>();
    return {p[0], p[1], p[2]};
}

double real_from(const Json& json) {
    if (!json.is_string()) return json.get<double>();
    constexpr double infinity = std::numeric_limits<double>::infinity();
    for (const double value : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()})
        if (json == real_json(value)) return value;
    throw Error("", "", in_quotes(json.get<std::string>()) + " is no number");
}

Error not_whole(const Json& json, const char* kind, const std::string& key) {
    const std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
    return {"", key, in_quotes(text) + " is no " + kind};
}

} // namespace keiko
