#pragma once

#include "keiko/intersect/hit/hit.h"
#include "keiko/intersect/hit/reflection_kernel.h"

namespace keiko {

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
