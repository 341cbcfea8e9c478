#pragma once

#include "keiko/raster/lit_pixels.h"
#include "keiko/raster/shadow_casters.h"
#include "keiko/raster/smooth_shading.h"

#include <algorithm>

namespace keiko::test {

/// True if `holds`(place, shares of the corners) for some place of a triangle within a subpixel of
/// a pixel's centre. `steps`: of the grid of places, on either side of the centre.
template <class Holds>
bool some_place_within_subpixel(const MeshView& view, std::uint32_t triangle, const Vec2& centre,
                                int steps, const Holds& holds) {
    constexpr double subpixel = 1.0 / 256;
    const auto corners = view.corners(triangle);
    for (int i = -steps; i <= steps; ++i)
        for (int j = -steps; j <= steps; ++j) {
            const Vec2 at = centre + Vec2(i, j) * (subpixel / steps);
            const Vec3 shares = ray_weights(corners, view.camera().ray(at.x, at.y));
            if (holds(mixed(shares, corners), shares)) return true;
        }
    return false;
}

/// Pixels whose light no ray has that starts within a subpixel of the centre. Those within a
/// subpixel of an edge, of their own triangle or of one that hides it, do not count.
inline int wrong_beyond_rounding(const MeshView& view, const ShadowCasters& casters,
                                 const Viewpoint& light, const Image& lit) {
    int wrong = 0;
    for (int y = 0; y < lit.height; ++y)
        for (int x = 0; x < lit.width; ++x) {
            const std::uint32_t own = view.items().at(x, y);
            if (own == no_index) continue;
            const auto some = [&](int steps, const auto& holds) {
                return some_place_within_subpixel(view, own, Vec2(x + 0.5, y + 0.5), steps, holds);
            };
            const auto has_light = [&](const Vec3& at, const Vec3&) {
                const bool reached = faces_light(view, own, light) && !casters.hide(at, light, own);
                return reached == (*lit.pixel(x, y) > 0);
            };
            const auto is_beside = [&](const Vec3& at, const Vec3& shares) {
                return !(std::min({shares.x, shares.y, shares.z}) >= 0) ||
                       casters.hide(at, eye_of(view.camera()), own);
            };
            const bool right = some(1, has_light) || some(1, is_beside) || some(16, has_light);
            wrong += right ? 0 : 1;
        }
    return wrong;
}

} // namespace keiko::test
