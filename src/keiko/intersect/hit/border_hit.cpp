#include "keiko/intersect/hit/border_hit.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Of the patch: the leaf without its overlaps. These shares tile the patch.
Box2 share(const Leaf& leaf) {
    const Box2 inner{leaf.domain.lower + leaf.slip, leaf.domain.upper - leaf.slip};
    return {Vec2(std::max(inner.lower.x, 0.0), std::max(inner.lower.y, 0.0)),
            Vec2(std::min(inner.upper.x, 1.0), std::min(inner.upper.y, 1.0))};
}

} // namespace

BorderHit border_hit(const TracedModel& model, const Crossing& crossing, Hit hit,
                     const Vec3& direction) {
    // Of a patch: rounding of the shares.
    constexpr double rounding = 1e-15;
    const Leaf& leaf = model.leaves.leaves[model.placed[crossing.leaf].leaf];
    BorderHit result;
    const double facing = model.patches[hit.patch].orientation(hit.uv);
    result.sine = facing * hit.normal.dot(direction) / direction.length();
    result.leaf = crossing.leaf;
    result.uv = crossing.uv;
    // Clipping ends in boxes without a proof: at a pole many of them stand for one root.
    result.own = !has(crossing.flags, HitFlags::clipped);
    const Box2 own = share(leaf);
    const Vec2 uv = leaf.patch_parameters(crossing.uv);
    const Vec2 error = crossing.error * leaf.domain.extent() + Vec2(rounding);
    for (unsigned k = 0; k < 2; ++k) {
        const double room = error[k] + 2 * leaf.slip[k];
        for (const double end : {own.lower[k], own.upper[k]})
            if (!(std::abs(uv[k] - end) > room)) result.at_end = true;
        const bool inside = uv[k] >= own.lower[k] + error[k] && uv[k] <= own.upper[k] - error[k];
        // What goes on past the patch's end is a neighbour's, too.
        if (!inside) result.own = false;
        if (!(uv[k] >= own.lower[k] && uv[k] <= own.upper[k])) result.at_end = true;
        if (!(crossing.uv[k] >= 0 && crossing.uv[k] <= 1)) result.beyond = true;
    }
    result.hit = std::move(hit);
    return result;
}

} // namespace keiko
