#include "keiko/raster/shadow_spans.h"

#include "keiko/math/interval_set.h"
#include "keiko/raster/light_pyramid.h"
#include "keiko/raster/lit_pixels.h"
#include "keiko/raster/smooth_shading.h"

#include <algorithm>
#include <array>
#include <vector>

namespace keiko {
namespace {

/// Pixels of a row that show one triangle.
struct Span {
    std::uint32_t triangle;
    int y, first, last;
};

/// Place on the plane of a triangle that shows at a place of the picture.
Vec3 met_by(const MeshView& view, std::uint32_t triangle, double x, double y) {
    const auto corners = view.corners(triangle);
    return mixed(ray_weights(corners, view.camera().ray(x, y)), corners);
}

/// The parts of a span that triangles shade, from its left end, 0, to its right one, 1.
IntervalSet shaded_parts(const LightPyramid& pyramid, const ShadowCasters& casters,
                         const Viewpoint& light, std::uint32_t own) {
    std::vector<ParameterInterval> parts;
    casters.tree().any_of(
        [&](const Box3& box) { return pyramid.meets(box); },
        [&](std::uint32_t triangle) {
            if (triangle == own || casters.hold(triangle, light)) return false;
            ParameterInterval part{1, 0};
            for (const Vec3& shares : pyramid.shadow_of(casters.corners(triangle)))
                part = {std::min(part.begin, shares.y), std::max(part.end, shares.y)};
            if (part.begin < part.end) parts.push_back(part);
            return false;
        });
    return IntervalSet(std::move(parts));
}

void light_span(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                const Span& span, Image& lit) {
    const double y = span.y + 0.5;
    const std::array<Vec3, 2> ends{met_by(view, span.triangle, span.first, y),
                                   met_by(view, span.triangle, span.last + 1, y)};
    const LightPyramid pyramid(ends, light, casters.rounding());
    if (!pyramid.lights()) return;
    const IntervalSet shaded = shaded_parts(pyramid, casters, light, span.triangle);
    const Vec3 along = ends[1] - ends[0];
    for (int x = span.first; x <= span.last; ++x) {
        const Vec3 way = met_by(view, span.triangle, x + 0.5, y) - ends[0];
        *lit.pixel(x, span.y) = shaded.contains(way.dot(along) / along.length2()) ? 0.0F : 1.0F;
    }
}

} // namespace

Image lit_by_spans(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                   const Job& job) {
    const ItemBuffer& items = view.items();
    Image lit(items.width, items.height, 1);
    parallel_for(static_cast<std::size_t>(items.height), job, "shadows", [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < items.width;) {
            Span span{items.at(x, y), y, x, x};
            while (++x < items.width && items.at(x, y) == span.triangle) span.last = x;
            if (span.triangle != no_index && faces_light(view, span.triangle, light))
                light_span(view, casters, light, span, lit);
        }
    });
    return lit;
}

} // namespace keiko
