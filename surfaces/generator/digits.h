#pragma once

#include <charconv>
#include <string>

namespace keiko::fixtures {

/// The shortest text that reads back as the same number, with a decimal point in any locale.
inline std::string digits(double value) {
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, value + 0.0).ptr;
    return {buffer, end};
}

} // namespace keiko::fixtures
