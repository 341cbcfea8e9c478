#pragma once

#include "keiko/patch/surface_model.h"
#include "keiko/trace/tracer.h"

#include <string>
#include <vector>

namespace keiko::bench {

/// Rays of one kind against one body.
struct RayClass {
    std::string name;
    std::vector<Ray> rays;
};

/// Primary rays of the best view in rows, the rays that the body mirrors of them, and seeded random
/// chords through its box.
std::vector<RayClass> ray_classes(const SurfaceModel& model, const Tracer& tracer);

} // namespace keiko::bench
