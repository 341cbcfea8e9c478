#pragma once

#include "keiko/intersect/hit/hit.h"

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

/// The ray that leaves the hit in mirror direction, excluding the hit's own root. When `incoming`
/// has differentials and the hit second derivatives, the reflected ray has them too, exact to first
/// order. They follow the transfer and reflection of [Igehy1999], with the surface's own curvature.
/// At poles, where the tangents are all but parallel, and at exact silhouettes it has none.
Ray reflect_ray(const Ray& incoming, const Hit& hit);
/// Writes the reflected ray into a blank ray.
void reflect_ray(const Ray& incoming, const Hit& hit, Ray& mirrored);

/// Makes reflected rays: reflect_ray() to the last bit, of several hits side by side.
class ReflectionBatch {
public:
    /// Batch without rays, which mirrors 8 of them at a time with the kernel.
    explicit ReflectionBatch(ReflectionKernel kernel) : kernel_(kernel) {}

    /// `mirrored`, which is blank, is written at the latest by finish(); all must stay where they
    /// are until then.
    void add(const Ray& incoming, const Hit& hit, Ray& mirrored);
    /// Writes the rays that still wait; the batch is empty then.
    void finish();

private:
    void ask(std::size_t lane);
    void write(std::size_t lane) const;

    ReflectionKernel kernel_;
    MirrorBlock block_;
    struct Asked {
        const Ray* incoming = nullptr;
        const Hit* hit = nullptr;
        Ray* mirrored = nullptr;
    };
    std::array<Asked, MirrorBlock::capacity> asked_{};
};

} // namespace keiko
