#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace keiko {

/// "1 seam", "2 seams", "0 seams": a number and the noun it is of, whose plural ends in s.
inline std::string counted(std::size_t number, std::string_view noun) {
    return std::to_string(number) + " " + std::string(noun) + (number == 1 ? "" : "s");
}

} // namespace keiko
