#include "keiko/placement/rated_rig.h"

#include "keiko/base/error.h"
#include "keiko/placement/plane_search.h"

namespace keiko {

Placement rated_rig(std::vector<ViewSample> seen, const SurfaceModel& model, int picture_height,
                    const LightRig& rig, const StripeSpacing& spacing) {
    LampField field(std::move(seen));
    if (!(field.total_weight() > 0))
        throw Error("", "placement", "no camera sees the surface that lamps are rated for");
    const StripeSpacing wanted = spacing.for_height(picture_height);
    Placement result;
    result.rig = rig;
    for (const LightSource& source : rig.sources) {
        const auto* lamps = std::get_if<CPlane>(&source);
        if (!lamps) continue;
        const PlaneSearch search(field, frame_of(*lamps), {lamps->lamps, wanted});
        const Box2 extent{Vec2(0), Vec2(lamps->u.length(), lamps->v.length())};
        const PlacementScore score = search.rated(extent).score;
        field.place(*lamps);
        result.planes.push_back({*lamps, score, hit_histogram(field, *lamps)});
    }
    if (result.planes.empty()) throw Error("", "rig", "it has no lamps on a C-plane to be rated");
    tell_what_is_reached(result, field, model, wanted);
    return result;
}

} // namespace keiko
