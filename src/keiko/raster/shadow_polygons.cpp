#include "keiko/raster/shadow_polygons.h"

#include "keiko/raster/light_pyramid.h"
#include "keiko/raster/lit_pixels.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

namespace keiko {
namespace {

/// A shadow on a triangle, by the shares of its first two corners.
using ShadowPolygon = std::vector<Vec3>;

/// Pixels that show triangles, sorted by these.
class SortedPixels {
public:
    SortedPixels(const ItemBuffer& items, std::size_t triangles) : begin_(triangles + 1) {
        for (const std::uint32_t triangle : items.shown)
            if (triangle != no_index) ++begin_[triangle + 1];
        for (std::size_t t = 0; t < triangles; ++t) begin_[t + 1] += begin_[t];
        pixels_.resize(begin_.back());
        std::vector<std::size_t> next(begin_.begin(), begin_.end() - 1);
        for (std::size_t pixel = 0; pixel < items.shown.size(); ++pixel)
            if (const std::uint32_t triangle = items.shown[pixel]; triangle != no_index)
                pixels_[next[triangle]++] = pixel;
    }

    /// Pixels of a triangle.
    std::span<const std::size_t> of(std::size_t triangle) const {
        return std::span(pixels_).subspan(begin_[triangle],
                                          begin_[triangle + 1] - begin_[triangle]);
    }

private:
    std::vector<std::size_t> begin_; ///< a triangle: its first in `pixels_`; one more
    std::vector<std::size_t> pixels_;
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
                                      const Viewpoint& light, std::uint32_t receiver) {
    std::vector<ShadowPolygon> shadows;
    casters.tree().any_of([&](const Box3& box) { return pyramid.meets(box); },
                          [&](std::uint32_t triangle) {
                              if (triangle == receiver || casters.hold(triangle, light))
                                  return false;
                              shadows.push_back(pyramid.shadow_of(casters.corners(triangle)));
                              if (shadows.back().size() < 3) shadows.pop_back();
                              return false;
                          });
    return shadows;
}

/// Lights the pixels of a triangle.
void light_pixels(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                  std::uint32_t triangle, std::span<const std::size_t> pixels, Image& lit) {
    const LightPyramid pyramid(view.corners(triangle), light, casters.rounding());
    if (!pyramid.lights() || !faces_light(view, triangle, light)) return;
    const std::vector<ShadowPolygon> shadows = shadows_on(pyramid, casters, light, triangle);
    for (const std::size_t number : pixels) {
        const auto pixel = static_cast<int>(number);
        const int x = pixel % lit.width, y = pixel / lit.width;
        const Vec3 shares = view.at(x, y)->weights;
        const bool dark = std::any_of(shadows.begin(), shadows.end(),
                                      [&](const auto& shadow) { return holds(shadow, shares); });
        *lit.pixel(x, y) = dark ? 0.0F : 1.0F;
    }
}

} // namespace

Image lit_by_polygons(const MeshView& view, const ShadowCasters& casters, const Viewpoint& light,
                      const Job& job) {
    const ItemBuffer& items = view.items();
    const std::size_t triangles = view.mesh().triangles.size();
    const SortedPixels sorted(items, triangles);
    Image lit(items.width, items.height, 1);
    constexpr std::size_t chunk = 64;
    parallel_for((triangles + chunk - 1) / chunk, job, "shadows", [&](std::size_t c) {
        for (std::size_t t = c * chunk; t < std::min(triangles, (c + 1) * chunk); ++t)
            if (const auto pixels = sorted.of(t); !pixels.empty())
                light_pixels(view, casters, light, static_cast<std::uint32_t>(t), pixels, lit);
    });
    return lit;
}

} // namespace keiko
