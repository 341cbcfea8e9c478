#include "keiko/simd/level.h"

#include <hwy/targets.h>

namespace keiko {

std::vector<SimdLevel> simd_levels() {
    std::vector<SimdLevel> levels;
#if defined(__x86_64__)
    const std::int64_t sets = hwy::SupportedTargets();
    if ((sets & HWY_AVX3) != 0) levels.push_back(SimdLevel::v4);
    if ((sets & HWY_AVX2) != 0) levels.push_back(SimdLevel::v3);
#endif
    levels.push_back(SimdLevel::base);
    return levels;
}

SimdLevel widest_simd_level() {
    return simd_levels().front();
}

std::string_view name_of(SimdLevel level) {
    switch (level) {
        case SimdLevel::v4:
            return "AVX-512";
        case SimdLevel::v3:
            return "AVX2";
        case SimdLevel::base:
            break;
    }
    return "baseline";
}

} // namespace keiko
