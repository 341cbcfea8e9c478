#pragma once

#include "keiko/math/bounds.h"

#include "tests/bench/contender.h"
#include <embree3/rtcore.h>

#include <array>
#include <vector>

namespace keiko::bench {

/// Ball that holds an Embree scene. Its coordinates are relative to the centre, and rays begin
/// where they enter the ball, so that single precision is spent on the body alone.
struct Ball {
    Vec3 center{0};
    double radius = 0;

    explicit Ball(const Box3& box) : center(box.center()), radius(box.size() / 2 * 1.001) {}
};

/// A hit as Embree leaves it.
struct EmbreeHit {
    unsigned primitive = 0;
    double t = 0; ///< in lengths of the ray's own direction
    float u = 0, v = 0;
};

/// Rays in Embree's form, made beforehand, in the layout of one mode; a run writes its hits into
/// them.
class EmbreeRays {
public:
    struct Options {
        /// mm: rays that start on the surface begin this far above it.
        double lift = 0;
        /// Rays end at Keiko's hit.
        bool end_at_hit = false;
    };

    EmbreeRays(const RaySet& rays, const Ball& ball, Mode mode, const Options& options);

    /// Takes back what a run wrote.
    void reset();
    /// The hit of ray i, or nothing.
    std::optional<EmbreeHit> hit(std::size_t i) const;

    struct alignas(64) Packet {
        RTCRayHit16 rays;
        std::array<int, 16> valid;
    };
    std::vector<RTCRayHit> singles;
    std::vector<Packet> packets;

private:
    struct Start {
        double t;        ///< where it begins, in lengths of the ray's own direction
        double per_mm;   ///< t per mm
        float near, far; ///< mm from there; near > far: it misses the ball
    };
    void write(std::size_t i, const Vec3& origin, const Vec3& direction);

    std::vector<Start> starts_;
};

} // namespace keiko::bench
