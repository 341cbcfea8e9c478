#include "keiko/raster/mesh_shadows.h"

#include "keiko/raster/lit_pixels.h"
#include "keiko/raster/shadow_map.h"
#include "keiko/raster/shadow_polygons.h"
#include "keiko/raster/shadow_spans.h"
#include "keiko/raster/shadow_volumes.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <functional>

namespace keiko {
namespace {

Image lit_by_rays(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                  const Job& job) {
    return lit_pixels_where(view, light, job, [&](const MeshPlace& place, int, int) {
        return !casters.hide(place.position, light, place.triangle);
    });
}

/// Illuminance by a point, up to a factor that is the same for all.
double weight_of(const EmittingPoint& point, const Vec3& place, const Vec3& normal) {
    const Vec3 way = point.position - place;
    const double square = way.length2(), emitted = -point.normal.dot(way);
    if (!(emitted > 0 && square > 0)) return 0;
    return point.area * emitted * std::abs(normal.dot(way)) / (square * square);
}

} // namespace

Image lit_pixels(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                 MeshShadows by, const Job& job) {
    switch (by) {
        case MeshShadows::none:
            return lit_pixels_where(view, light, job,
                                    [](const MeshPlace&, int, int) { return true; });
        case MeshShadows::scan_line:
            return lit_by_spans(view, casters, light, job);
        case MeshShadows::map:
            return lit_by_map(view, casters, light, job);
        case MeshShadows::polygons:
            return lit_by_polygons(view, casters, light, job);
        case MeshShadows::volumes:
            return lit_by_volumes(view, casters, light, job);
        default:
            return lit_by_rays(view, casters, light, job);
    }
}

Image lit_pixels(const MeshView& view, const ShadowCasters& casters,
                 std::span<const EmittingPoint> points, MeshShadows by, const Job& job) {
    const ItemBuffer& items = view.items();
    Image lit(items.width, items.height, 1), all(items.width, items.height, 1);
    for (const EmittingPoint& point : points) {
        assert(point.area > 0);
        const Viewpoint light = Viewpoint::at(point.position);
        const Image reached = lit_pixels(view, casters, light, by, job);
        const auto add = [&](const MeshPlace& place, int x, int y) {
            if (!faces_light(view, place.triangle, light)) return 0.0;
            const double weight =
                weight_of(point, place.position, view.facet_normal(place.triangle));
            *all.pixel(x, y) += static_cast<float>(weight);
            return weight * double{*reached.pixel(x, y)};
        };
        const Image weighted = share_of_pixels(view, job, add);
        std::transform(lit.values.begin(), lit.values.end(), weighted.values.begin(),
                       lit.values.begin(), std::plus<>());
    }
    std::transform(lit.values.begin(), lit.values.end(), all.values.begin(), lit.values.begin(),
                   [](float reached, float sum) {
                       return sum > 0 ? std::clamp(reached / sum, 0.0F, 1.0F) : 0.0F;
                   });
    return lit;
}

} // namespace keiko
