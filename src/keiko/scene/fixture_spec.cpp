#include "keiko/scene/fixture_spec.h"

#include "keiko/base/error.h"

#include <algorithm>

namespace keiko {
namespace {

constexpr std::array<std::string_view, quantity_count> names{
    "count", "verdict", "place",     "length", "area", "direction",
    "gap",   "angle",   "curvature", "slope",  "line", "share"};
constexpr std::array<std::string_view, quantity_count> units{"",   "",    "mm", "mm",  "mm2", "",
                                                             "mm", "deg", "",   "deg", "mm",  ""};

} // namespace

std::string_view name_of(Quantity quantity) {
    return names[static_cast<std::size_t>(quantity)];
}

std::string_view unit_of(Quantity quantity) {
    return units[static_cast<std::size_t>(quantity)];
}

Quantity quantity_by_name(std::string_view name) {
    const auto found = std::find(names.begin(), names.end(), name);
    if (found == names.end()) throw Error("", in_quotes(name), "is no quantity");
    return static_cast<Quantity>(found - names.begin());
}

} // namespace keiko
