#pragma once

#include "keiko/intersect/hit/hit.h"
#include "keiko/intersect/hit/reflection_kernel.h"

namespace keiko {

/// Makes reflected rays: reflect_ray() to the last bit, of several hits side by side.
class ReflectionBatch {
public:
    explicit ReflectionBatch(ReflectionKernel kernel) : kernel_(kernel) {}

    /// `mirrored`, which is blank, is written at the latest by finish(); all must stay where they
    /// are until then.
    void add(const Ray& incoming, const Hit& hit, Ray& mirrored);
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
