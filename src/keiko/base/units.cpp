#include "keiko/base/units.h"

#include "keiko/base/text.h"

#include <array>
#include <string>
#include <utility>

namespace keiko {

std::optional<double> millimetres_per(std::string_view unit) {
    static constexpr std::array<std::pair<std::string_view, double>, 17> table{{
        {"mm", 1.0},
        {"millimetre", 1.0},
        {"millimeter", 1.0},
        {"cm", 10.0},
        {"centimetre", 10.0},
        {"centimeter", 10.0},
        {"m", 1000.0},
        {"metre", 1000.0},
        {"meter", 1000.0},
        {"km", 1e6},
        {"um", 1e-3},
        {"in", 25.4},
        {"inch", 25.4},
        {"mil", 0.0254},
        {"ft", 304.8},
        {"foot", 304.8},
        {"yd", 914.4},
    }};
    const std::string name = lower_case(std::string(unit));
    for (const auto& [known, factor] : table)
        if (known == name) return factor;
    return std::nullopt;
}

} // namespace keiko
