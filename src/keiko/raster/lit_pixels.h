#pragma once

#include "keiko/base/job.h"
#include "keiko/base/parallel.h"
#include "keiko/film/film.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/raster/mesh_view.h"

#include <cstddef>
#include <cstdint>

namespace keiko {

/// The eye of a camera as a viewpoint.
inline Viewpoint eye_of(const Camera& camera) {
    return camera.projection == Projection::perspective
               ? Viewpoint::at(camera.eye)
               : Viewpoint::towards(-camera.axes().forward);
}

/// True if the side of a triangle that the eye sees faces a light.
inline bool faces_light(const MeshView& view, std::uint32_t triangle, const Viewpoint& light) {
    const Vec3 normal = view.facet_normal(triangle), corner = view.corners(triangle)[0];
    return normal.dot(eye_of(view.camera()).way_to(corner)) * normal.dot(light.way_to(corner)) > 0;
}

/// Shares of a light at the pixels of a view, 0 to 1, one channel: `share`(place, x, y) where a
/// triangle is seen, and 0 elsewhere. Rows on several threads. Throws Cancelled.
template <class Share>
Image share_of_pixels(const MeshView& view, const Job& job, const Share& share) {
    const ItemBuffer& items = view.items();
    Image lit(items.width, items.height, 1);
    parallel_for(static_cast<std::size_t>(items.height), job, "shadows", [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < items.width; ++x)
            if (const auto place = view.at(x, y))
                *lit.pixel(x, y) = static_cast<float>(share(*place, x, y));
    });
    return lit;
}

/// share_of_pixels() of a light without extent that `reaches`(place, x, y) some places: 1 there if
/// the facet faces it, else 0.
template <class Reaches>
Image lit_pixels_where(const MeshView& view, const Viewpoint& light, const Job& job,
                       const Reaches& reaches) {
    return share_of_pixels(view, job, [&](const MeshPlace& place, int x, int y) {
        return faces_light(view, place.triangle, light) && reaches(place, x, y) ? 1 : 0;
    });
}

} // namespace keiko
