#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/intersect/traversal/tracer.h"
#include "keiko/scene/camera.h"

#include "tests/bench/ray_set.h"

#include <vector>

namespace keiko::bench {

/// The camera that primary rays come from: the best view of the body, of about `rays` pixels.
Camera bench_camera(const SurfaceModel& model, const Tracer& tracer, std::size_t rays);

/// One ray a pixel, in blocks of 4 x 4 pixels. Their differentials are for a pixel of the same
/// picture in 1920 x 1080, so that errors in pixels do not depend on the number of rays.
RaySet primary_rays(const Camera& camera, const Tracer& tracer);

/// Reflected rays of those primary rays, in their order, each excluding the root it starts from.
RaySet mirrored_rays(const RaySet& primary, const Tracer& tracer);

/// Seeded chords between points of the body's box, from outside of it.
RaySet random_rays(const Tracer& tracer, std::size_t count);

/// All classes: primary, mirrored, random, grazing. `tracer` gives the truth: it must compute
/// second derivatives.
std::vector<RaySet> ray_classes(const SurfaceModel& model, const Tracer& tracer, std::size_t count);

} // namespace keiko::bench
