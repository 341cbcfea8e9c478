#include "keiko/light/rig/rig_areas.h"

#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/luminance/flush.h"

#include <algorithm>

namespace keiko {
namespace {

template <AreaLight Light>
Box3 box_around(const Light& light) {
    Box3 box;
    for (const Vec3& corner : bounds_of(light)) box.extend(corner);
    return box;
}

} // namespace

RigAreas::RigAreas(const LightRig& rig) {
    for (const LightSource& source : rig.sources) {
        if (const auto* panel = std::get_if<PolygonLight>(&source))
            areas_.push_back({PanelOutline(*panel), panel->luminance, box_around(*panel)});
        if (const auto* sphere = std::get_if<SphereLight>(&source))
            areas_.push_back({*sphere, sphere->luminance, box_around(*sphere)});
    }
}

std::vector<RigAreas::Layer> RigAreas::along(const Vec3& origin, const Vec3& direction,
                                             const std::optional<RayDifferentials>& spread,
                                             double t_max) const {
    std::vector<Layer> layers;
    for (const Area& area : areas_) {
        const auto hit = std::visit(
            [&](const auto& shape) { return area_hit(shape, origin, direction, spread); },
            area.shape);
        if (hit && hit->t * (1 - flush) < t_max) layers.push_back({*hit, area.luminance});
    }
    std::stable_sort(layers.begin(), layers.end(),
                     [](const Layer& a, const Layer& b) { return a.hit.t < b.hit.t; });
    return layers;
}

std::vector<Box3> RigAreas::boxes() const {
    std::vector<Box3> boxes;
    for (const Area& area : areas_) boxes.push_back(area.box);
    return boxes;
}

} // namespace keiko
