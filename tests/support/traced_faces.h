#pragma once

#include "keiko/intersect/traversal/tracer.h"
#include "keiko/raster/item_buffer.h"
#include "keiko/scene/camera.h"

namespace keiko::test {

/// The face of each pixel's first hit.
inline ItemBuffer traced_faces(const SurfaceModel& model, const Camera& camera) {
    const Tracer tracer(model);
    ItemBuffer seen(camera.width, camera.height);
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x)
            if (const auto hit = tracer.nearest(camera.ray(x + 0.5, y + 0.5)))
                seen.shown[seen.index(x, y)] = hit->face;
    return seen;
}

} // namespace keiko::test
