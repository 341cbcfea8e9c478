#include "keiko/report/markup/json_text.h"

#include "keiko/base/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace keiko {
namespace {

/// JSON by nlohmann-json with terminal control characters as \uXXXX, which occur only in its
/// strings. Line breaks between its values stay.
std::string with_controls_escaped(std::string_view text) {
    std::string escaped;
    while (!text.empty()) {
        const std::size_t length = utf8_length(text);
        const char32_t character = length > 0 ? code_point(text.substr(0, length)) : 0;
        if (length > 0 && character != '\n' && controls_terminal(character)) {
            char code[8];
            std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(character));
            escaped += code;
        } else {
            escaped += text.substr(0, std::max<std::size_t>(length, 1));
        }
        text.remove_prefix(std::max<std::size_t>(length, 1));
    }
    return escaped;
}

} // namespace

std::string text_of(const Json& json) {
    return with_controls_escaped(json.dump(1, ' ', false, Json::error_handler_t::replace)) + "\n";
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
