#pragma once

#include "keiko/base/job.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/placement/feature_direction.h"
#include "keiko/scene/camera.h"

#include <span>
#include <vector>

namespace keiko {

/// What a place in the picture counts.
enum class SampleWeight {
    solid_angle, ///< the solid angle it covers
    pixels       ///< every pixel the same, as in [NishitaTubes]
};

/// A place of a picture that sees the surface, and what it mirrors.
struct ViewSample {
    std::uint32_t view = 0; ///< which of the cameras
    std::uint32_t instance = 0, face = 0;
    Vec2 pixel{0};
    int edge = 1; ///< pixels, of the square that it stands for
    double weight = 0;
    Vec3 eye{0};          ///< origin of the camera ray
    Vec3 normal{0};       ///< unit, on the side of the eye
    Ray mirror;           ///< from the surface along the mirror direction
    bool blocked = false; ///< the reflected ray meets the body again
    FeatureDirection feature;

    const Vec3& position() const { return mirror.origin; }
};

struct SamplingOptions {
    int samples = 40000; ///< about so many pixels of each picture are looked at
    SampleWeight weight = SampleWeight::solid_angle;
    std::vector<std::uint32_t> faces; ///< faces of the model that count; empty: all of them
};

/// Looks at the body through an even grid of pixels of each camera. In the order of cameras, rows
/// and columns; the same for any thread count.
std::vector<ViewSample> sample_views(const Tracer& tracer, const SurfaceModel& model,
                                     std::span<const Camera> cameras,
                                     const SamplingOptions& options, const Job& job = {});

} // namespace keiko
