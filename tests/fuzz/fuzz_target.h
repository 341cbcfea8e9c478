#pragma once

#include "keiko/base/error.h"

#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

/// Function that a fuzzer, or replay.cpp, calls with one input after the other.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace keiko::fuzz {

inline std::string_view text_of(const std::uint8_t* data, std::size_t size) {
    return {reinterpret_cast<const char*>(data), size};
}

/// Ends the program where a promise of the code under test does not hold: a finding.
inline void require(bool holds, const char* promise) {
    if (holds) return;
    std::fprintf(stderr, "broken promise: %s\n", promise);
    std::abort();
}

/// Bad input is reported in one line that a terminal can show.
inline void require_clear(const Error& error) {
    constexpr std::size_t longest = 1000;
    const std::string_view line = error.what();
    require(!error.reason().empty(), "an error has a reason");
    require(line.size() <= longest, "an error is short");
    require(
        std::none_of(line.begin(), line.end(), [](unsigned char c) { return c < ' ' || c == 127; }),
        "an error is one line of printable text");
}

/// Whether `read` gives a value. The only other thing it may do is throw a clear Error.
template <class Read>
bool accepts(const Read& read) {
    try {
        read();
        return true;
    } catch (const Error& error) {
        require_clear(error);
        return false;
    }
}

} // namespace keiko::fuzz
