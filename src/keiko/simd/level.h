#pragma once

#include <string_view>
#include <vector>

/// Declares a function without arguments in the namespace of each level that kernels are compiled
/// for.
#if defined(__x86_64__)
#define KEIKO_OF_EVERY_LEVEL(Result, function) \
    namespace level_base {                     \
    Result function();                         \
    }                                          \
    namespace level_v3 {                       \
    Result function();                         \
    }                                          \
    namespace level_v4 {                       \
    Result function();                         \
    }
/// Calls the function of a level.
#define KEIKO_AT_LEVEL(level, function)                \
    ((level) == SimdLevel::v4   ? level_v4::function() \
     : (level) == SimdLevel::v3 ? level_v3::function() \
                                : level_base::function())
#else
#define KEIKO_OF_EVERY_LEVEL(Result, function) \
    namespace level_base {                     \
    Result function();                         \
    }
#define KEIKO_AT_LEVEL(level, function) level_base::function()
#endif

namespace keiko {

/// Instruction sets that kernels are compiled for, by the levels of the x86-64 ABI.
enum class SimdLevel {
    base, ///< what every processor of the family has
    v3,   ///< x86-64-v3: AVX2 and FMA
    v4    ///< x86-64-v4: AVX-512
};

/// Levels that this processor has, the widest first.
std::vector<SimdLevel> simd_levels();
/// The widest of them.
SimdLevel widest_simd_level();
/// Short name of a level.
std::string_view name_of(SimdLevel level);

} // namespace keiko
