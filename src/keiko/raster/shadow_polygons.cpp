#include "keiko/raster/shadow_polygons.h"

#include "keiko/raster/light_pyramid.h"
#include "keiko/raster/lit_pixels.h"

#include <algorithm>
#include <array>
#include <vector>

namespace keiko {
namespace {

/// A shadow on a triangle, by the shares of its first two corners.
using ShadowPolygon = std::vector<Vec3>;

/// Pixels that show triangles, sorted by these.
struct SortedPixels {
    std::vector<std::size_t> begin; ///< a triangle: its first in `pixels`; one more
    std::vector<std::size_t> pixels;

    SortedPixels(const ItemBuffer& items, std::size_t triangles) : begin(triangles + 1) {
        for (const std::uint32_t triangle : items.shown)
            if (triangle != no_index) ++begin[triangle + 1];
        for (std::size_t t = 0; t < triangles; ++t) begin[t + 1] += begin[t];
        pixels.resize(begin.back());
        std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
        for (std::size_t pixel = 0; pixel < items.shown.size(); ++pixel)
            if (items.shown[pixel] != no_index) pixels[next[items.shown[pixel]]++] = pixel;
    }
};

/// True for a place in a convex polygon of either sense.
bool holds(const ShadowPolygon& polygon, const Vec3& shares) {
    bool left = true, right = true;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double side = (b.x - a.x) * (shares.y - a.y) - (b.y - a.y) * (shares.x - a.x);
        left &= side >= 0, right &= side <= 0;
    }
    return left || right;
}

std::vector<ShadowPolygon> shadows_on(const LightPyramid& pyramid, const ShadowCasters& casters,
                                      std::uint32_t receiver) {
    std::vector<ShadowPolygon> shadows;
    casters.tree().any_of([&](const Box3& box) { return pyramid.meets(box); },
                          [&](std::uint32_t triangle) {
                              if (triangle == receiver) return false;
                              shadows.push_back(pyramid.shadow_of(casters.corners(triangle)));
                              if (shadows.back().size() < 3) shadows.pop_back();
                              return false;
                          });
    return shadows;
}

} // namespace

Image lit_by_polygons(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                      const Job& job) {
    const ItemBuffer& items = view.items();
    const std::size_t triangles = view.mesh().triangles.size();
    const SortedPixels sorted(items, triangles);
    Image lit(items.width, items.height, 1);
    const auto light_triangle = [&](std::uint32_t t) {
        const LightPyramid pyramid(view.corners(t), light, casters.rounding());
        if (!pyramid.lights() || !faces_light(view, t, light)) return;
        const std::vector<ShadowPolygon> shadows = shadows_on(pyramid, casters, t);
        for (std::size_t i = sorted.begin[t]; i < sorted.begin[t + 1]; ++i) {
            const auto pixel = static_cast<int>(sorted.pixels[i]);
            const int x = pixel % items.width, y = pixel / items.width;
            const Vec3 shares = view.at(x, y)->weights;
            const bool dark = std::any_of(shadows.begin(), shadows.end(), [&](const auto& shadow) {
                return holds(shadow, shares);
            });
            *lit.pixel(x, y) = dark ? 0.0F : 1.0F;
        }
    };
    constexpr std::size_t chunk = 64;
    parallel_for((triangles + chunk - 1) / chunk, job, "shadows", [&](std::size_t c) {
        for (std::size_t t = c * chunk; t < std::min(triangles, (c + 1) * chunk); ++t)
            if (sorted.begin[t] < sorted.begin[t + 1])
                light_triangle(static_cast<std::uint32_t>(t));
    });
    return lit;
}

} // namespace keiko
