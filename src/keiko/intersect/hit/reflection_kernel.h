#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace keiko {

/// Up to 8 rays with differentials at their hits with second derivatives, as arrays of their
/// numbers, and what is mirrored of them.
struct alignas(64) MirrorBlock {
    static constexpr std::size_t capacity = 8;
    using Lanes = std::array<double, capacity>;
    using Vectors = std::array<Lanes, 3>;
    struct Differentials {
        Vectors origin_dx{}, origin_dy{}, direction_dx{}, direction_dy{};
    };

    // What is asked.
    Vectors direction{};
    Differentials incoming{};
    Lanes t{};
    Vectors normal{}, du{}, dv{}, duu{}, duv{}, dvv{};
    // What is there.
    Vectors mirrored_direction{};
    Differentials mirrored{};
    std::uint32_t plain = 0; ///< a bit a lane: no pole, no silhouette; the others say nothing
    // What is asked, after what is read a vector at a time.
    std::size_t count = 0; ///< lanes from here on hold numbers of earlier rays
};

/// Kernel that does reflect_ray() side by side: for lanes of `plain` the same to the last bit, on
/// every instruction set.
using ReflectionKernel = void (*)(MirrorBlock&);

/// The widest that this processor has.
ReflectionKernel reflection_kernel();

} // namespace keiko
