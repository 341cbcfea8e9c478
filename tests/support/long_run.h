#pragma once

#include <cstdint>
#include <cstdlib>
#include <string_view>

namespace keiko::test {

/// Whether `./dev test --long` runs: property tests then take a hundred times the rays.
inline bool long_run() {
    const char* value = std::getenv("KEIKO_LONG");
    return value != nullptr && std::string_view(value) == "1";
}

/// How many rays a property test takes.
inline std::size_t ray_count(std::size_t usual, std::size_t in_long_run) {
    return long_run() ? in_long_run : usual;
}

/// First seed of a test: KEIKO_SEED, for rays that no run has traced yet; else 1.
inline std::uint64_t first_seed() {
    const char* value = std::getenv("KEIKO_SEED");
    return value != nullptr ? std::strtoull(value, nullptr, 10) : 1;
}

} // namespace keiko::test
