#include "keiko/light/rig/rig_areas.h"

#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/luminance/flush.h"

#include <algorithm>
#include <type_traits>

namespace keiko {
namespace {

template <AreaLight Light>
Box3 box_around(const Light& light) {
    Box3 box;
    for (const Vec3& corner : bounds_of(light)) box.extend(corner);
    return box;
}

template <AreaLight Light>
bool is_shown(const Light& /*light*/) {
    return true;
}
bool is_shown(const PolygonLight& light) {
    return light.shown;
}

template <AreaLight Light>
const Light& shape_of(const Light& light) {
    return light;
}
PanelOutline shape_of(const PolygonLight& light) {
    return PanelOutline(light);
}

} // namespace

RigAreas::RigAreas(const LightRig& rig) {
    for (const LightSource& source : rig.sources)
        std::visit(
            [&](const auto& light) {
                if constexpr (AreaLight<std::decay_t<decltype(light)>>)
                    if (is_shown(light))
                        areas_.push_back({shape_of(light), light.luminance, box_around(light)});
            },
            source);
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
