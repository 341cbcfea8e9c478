#include "tests/bench/machine.h"

#include <array>
#include <ctime>
#include <fstream>

namespace keiko::bench {
namespace {

std::string cpu_model() {
    std::ifstream info("/proc/cpuinfo");
    for (std::string line; std::getline(info, line);)
        if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
    return "unknown";
}

/// Widest instruction set that the processor offers; a library may use less.
std::string widest_simd() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f")) return "AVX-512";
    if (__builtin_cpu_supports("avx2")) return "AVX2";
    return "SSE";
#else
    return "unknown";
#endif
}

std::string compiler() {
#if defined(__clang__)
    return "clang " + std::to_string(__clang_major__) + "." + std::to_string(__clang_minor__);
#else
    return "gcc " + std::to_string(__GNUC__) + "." + std::to_string(__GNUC_MINOR__);
#endif
}

std::string today() {
    const std::time_t now = std::time(nullptr);
    std::array<char, 16> text{};
    std::tm day{};
    gmtime_r(&now, &day);
    std::strftime(text.data(), text.size(), "%Y-%m-%d", &day);
    return text.data();
}

} // namespace

Machine this_machine() {
    return {cpu_model(), widest_simd(), compiler(), today()};
}

} // namespace keiko::bench
