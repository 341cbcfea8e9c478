#include "keiko/render/shading/direct_lighting.h"

#include "keiko/render/shading/light_bounds.h"
#include "keiko/render/shading/occluded_visibility.h"

#include <algorithm>
#include <iterator>

namespace keiko {

std::vector<LightVisibility> DirectLighting::light_visibility(const Vec3& point, const Vec3& normal,
                                                              const std::optional<Root>& root,
                                                              std::span<const LightId> lights,
                                                              TubeModel model, bool axes) const {
    std::vector<LightVisibility> all;
    each_source(lights, [&](std::size_t i, std::span<const int> lamps, std::size_t) {
        const LightSource& source = rig_.sources[i];
        const OccludedVisibility visible(
            occluders_, tracer_, Viewpoint::at(point, root),
            occluders_ ? light_bounds(source, lamps, point) : std::vector<Vec3>(), {}, normal);
        std::vector<LightVisibility> seen = light_visibilities(
            source, lamps, point, normal, visible, model, axes || rig_.medium.has_value());
        if (seen.size() == lights.size())
            all = std::move(seen);
        else
            std::move(seen.begin(), seen.end(), std::back_inserter(all));
    });
    return all;
}

bool DirectLighting::may_occlude(std::span<const Vec3> places, const LightId& light,
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
    return occluders_->may_occlude(places, region, facing);
}

} // namespace keiko
