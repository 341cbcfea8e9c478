#include "keiko/intersect/hit/boundary_hit.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// Of the patch: the sub-patch without its overlaps. These shares tile the patch.
Box2 share(const SubPatch& sub_patch) {
    const Box2 inner{sub_patch.domain.lower + sub_patch.slip,
                     sub_patch.domain.upper - sub_patch.slip};
    return {Vec2(std::max(inner.lower.x, 0.0), std::max(inner.lower.y, 0.0)),
            Vec2(std::min(inner.upper.x, 1.0), std::min(inner.upper.y, 1.0))};
}

} // namespace

BoundaryHit boundary_hit(const TracedModel& model, const Crossing& crossing, Hit hit,
                         const Vec3& direction) {
    // Of a patch: rounding of the shares.
    constexpr double rounding = 1e-15;
    const SubPatch& sub_patch =
        model.sub_patches.sub_patches[model.placed[crossing.sub_patch].sub_patch];
    BoundaryHit result;
    const double facing = model.patches[hit.patch].orientation(hit.uv);
    result.sine = facing * hit.normal.dot(direction) / direction.length();
    result.sub_patch = crossing.sub_patch;
    result.uv = crossing.uv;
    // Clipping ends in boxes without a proof: at a pole many of them stand for one root.
    result.own = !has(crossing.flags, HitFlags::clipped);
    const Box2 own = share(sub_patch);
    const Vec2 uv = sub_patch.patch_parameters(crossing.uv);
    const Vec2 error = crossing.error * sub_patch.domain.extent() + Vec2(rounding);
    for (unsigned k = 0; k < 2; ++k) {
        const double room = error[k] + 2 * sub_patch.slip[k];
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
