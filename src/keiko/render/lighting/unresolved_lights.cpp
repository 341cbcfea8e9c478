#include "keiko/render/lighting/unresolved_lights.h"

namespace keiko {

std::optional<LightVisibility> seen_between_corners(const LightSamples& lights,
                                                    const ShadingGrid& grid,
                                                    const LinearlySeen& linear, const Pixel& p) {
    const auto [a, b, c, d] = linear.between.corners();
    const auto at = [&](const Pixel& corner) {
        return lights.seen(corner.x, corner.y, linear.light);
    };
    const Vec2 share = grid.share(linear.between, p);
    const auto upper = between(at(a), at(b), share.x), lower = between(at(c), at(d), share.x);
    return upper && lower ? between(*upper, *lower, share.y) : std::nullopt;
}

void find(const UnresolvedLights& open, const ShadingGrid& grid, const Pixel& p,
          LightSamples& lights) {
    lights.find_for_sure(p.x, p.y, open.seen);
    for (const LinearlySeen& linear : open.linearly_seen) {
        if (!holds(open.lit, linear.light) || lights.is_seen(p.x, p.y, linear.light)) continue;
        if (const auto seen = seen_between_corners(lights, grid, linear, p))
            lights.take(p.x, p.y, linear.light, *seen);
    }
    lights.find(p.x, p.y, open.lit);
}

} // namespace keiko
