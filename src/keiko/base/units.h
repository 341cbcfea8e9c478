#pragma once

#include <numbers>
#include <optional>
#include <string_view>

namespace keiko {

/// Angle in radians of one in degrees, of any size and sign.
constexpr double degrees_to_radians(double degrees) {
    return degrees * std::numbers::pi / 180;
}
/// Angle in degrees of one in radians, of any size and sign.
constexpr double radians_to_degrees(double radians) {
    return radians * 180 / std::numbers::pi;
}

/// Millimetres in one `unit` (um, mm, cm, m, km, mil, in, ft, yd; any case, some spelt out too), or
/// nothing for a name that is no length unit.
std::optional<double> millimetres_per(std::string_view unit);

} // namespace keiko
