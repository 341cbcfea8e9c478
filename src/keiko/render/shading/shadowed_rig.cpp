#include "keiko/render/shading/shadowed_rig.h"

#include "keiko/render/shading/seen_past.h"
#include "keiko/render/shading/source_region.h"

#include <algorithm>
#include <iterator>

namespace keiko {

std::vector<SeenLight> ShadowedRig::seen_from(const Vec3& point, const Vec3& normal,
                                              const std::optional<Root>& root,
                                              std::span<const RigLight> lights, TubeModel model,
                                              bool axes) const {
    std::vector<SeenLight> all;
    each_source(lights, [&](std::size_t i, std::span<const int> lamps, std::size_t) {
        const LightSource& source = rig_.sources[i];
        const SeenPast visible(
            occluders_, tracer_, Apex::at(point, root),
            occluders_ ? source_region(source, lamps, point) : std::vector<Vec3>(), {}, normal);
        std::vector<SeenLight> seen = seen_lights(source, lamps, point, normal, visible, model,
                                                  axes || rig_.medium.has_value());
        if (seen.size() == lights.size())
            all = std::move(seen);
        else
            std::move(seen.begin(), seen.end(), std::back_inserter(all));
    });
    return all;
}

bool ShadowedRig::may_come_between(std::span<const Vec3> places, const RigLight& light,
                                   const std::optional<Vec3>& facing, TubeModel model) const {
    if (!occluders_) return false;
    const LightSource& source = rig_.sources[light.source];
    const auto* sun = std::get_if<Sun>(&source);
    if (sun && !sun->windows.empty()) return true; // their frames stand in its way, too
    std::vector<Vec3> region;
    // Only the sun stands elsewhere from place to place.
    for (const Vec3& place : sun ? places : places.first(1))
        for (const Vec3& corner : lamp_corners(source, light.lamp, place, model))
            region.push_back(corner);
    return occluders_->may_come_between(places, region, facing);
}

} // namespace keiko
