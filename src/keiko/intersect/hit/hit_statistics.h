#pragma once

#include "keiko/intersect/hit/hit.h"

#include <cstdint>
#include <string>

namespace keiko {

/// How many hits were found in which way.
struct HitStatistics {
    std::uint64_t unique = 0;     ///< proved to be the only root of their sub-patch
    std::uint64_t clipped = 0;    ///< finished by clipping
    std::uint64_t tangential = 0; ///< the ray touches, finished by clipping or not

    std::uint64_t sum() const { return unique + clipped + tangential; }
    void count(const Hit& hit);
    HitStatistics& operator+=(const HitStatistics& other);
    bool operator==(const HitStatistics&) const = default;
};

/// "1234 hits: 98.10 % unique, 1.80 % clipped, 0.10 % tangential"
std::string path_text(const HitStatistics& counts);

} // namespace keiko
