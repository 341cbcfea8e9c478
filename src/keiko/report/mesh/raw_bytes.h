#pragma once

#include <cstring>
#include <string>

namespace keiko {

/// Appends the bytes of a number as they lie in memory.
template <class Number>
void append(std::string& bytes, Number number) {
    char piece[sizeof number];
    std::memcpy(piece, &number, sizeof number);
    bytes.append(piece, sizeof number);
}

} // namespace keiko
