#include "keiko/report/json_text.h"

#include <array>
#include <cmath>

namespace keiko {

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
    return json.is_string() ? std::stod(json.get<std::string>()) : json.get<double>();
}

} // namespace keiko
