#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace keiko {

/// Up to 8 rays with differentials at their hits with second derivatives, as arrays of their
/// numbers, and what is mirrored of them.
struct alignas(64) MirrorBlock {
    static constexpr std::size_t capacity = 8;  ///< most rays of a block
    using Lanes = std::array<double, capacity>; ///< One number of each ray.
    using Vectors = std::array<Lanes, 3>;       ///< One world vector of each ray: x, y, z.
    /// Derivatives of each ray's origin and direction by the pixel's two coordinates, mm.
    struct Differentials {
        Vectors origin_dx{}, origin_dy{};       ///< of the origin
        Vectors direction_dx{}, direction_dy{}; ///< of the direction
    };

    // What is asked.
    Vectors direction{};         ///< of the incoming rays, of any length
    Differentials incoming{};    ///< of the incoming rays
    Lanes t{};                   ///< parameter of the incoming ray at its hit
    Vectors normal{};            ///< unit, of either sense
    Vectors du{}, dv{};          ///< first derivatives of the surface, mm
    Vectors duu{}, duv{}, dvv{}; ///< second derivatives of the surface, mm
    // What is there.
    Vectors mirrored_direction{}; ///< of the reflected rays, as long as the incoming ones
    Differentials mirrored{};     ///< of the reflected rays
    std::uint32_t plain = 0;      ///< a bit a lane: no pole, no silhouette; the others say nothing
    // What is asked, after what is read a vector at a time.
    std::size_t count = 0; ///< lanes from here on hold numbers of earlier rays
};

/// Kernel that does reflect_ray() side by side: for lanes of `plain` the same to the last bit, on
/// every instruction set.
using ReflectionKernel = void (*)(MirrorBlock&);

/// Kernel for the widest instruction set that this processor has.
ReflectionKernel reflection_kernel();

} // namespace keiko
