#pragma once

#include "keiko/math/vec.h"

#include <random>

namespace keiko::test {

using Random = std::mt19937_64;

inline double uniform(Random& random, double low, double high) {
    return low + (high - low) * std::uniform_real_distribution<double>(0, 1)(random);
}

/// One of 0 .. count - 1.
inline std::size_t pick(Random& random, std::size_t count) {
    return static_cast<std::size_t>(random() % count);
}

inline Vec3 random_direction(Random& random) {
    for (;;) {
        const Vec3 v(uniform(random, -1, 1), uniform(random, -1, 1), uniform(random, -1, 1));
        if (v.length2() > 0.01 && v.length2() < 1) return v.normalized();
    }
}

} // namespace keiko::test
