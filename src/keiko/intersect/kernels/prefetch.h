#pragma once

#include <hwy/cache_control.h>

#include <span>

namespace keiko {

/// Asks for values to be in the cache by the time they are read.
template <class T>
void prefetch(std::span<const T> values) {
    constexpr std::size_t line = 64;
    const auto* bytes = reinterpret_cast<const char*>(values.data());
    for (std::size_t at = 0; at < values.size_bytes(); at += line) hwy::Prefetch(bytes + at);
}

} // namespace keiko
