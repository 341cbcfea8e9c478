#include "keiko/light/rig/rig_areas.h"

#include "keiko/light/areas/area_coverage.h"
#include "keiko/light/areas/area_irradiance.h"

#include <algorithm>
#include <type_traits>

namespace keiko {
namespace {

/// Calls `use` for a panel or a sphere.
template <class Use>
void use_area(const LightSource& source, const Use& use) {
    std::visit(
        [&](const auto& light) {
            if constexpr (AreaLight<std::decay_t<decltype(light)>>) use(light);
        },
        source);
}

struct Layer {
    AreaHit hit;
    Rgb luminance;
};

} // namespace

RigAreas::RigAreas(const LightRig& rig) {
    for (const LightSource& source : rig.sources)
        use_area(source, [&](const auto& light) { lights_.emplace_back(light); });
}

RigAreas::Visible RigAreas::along(const Vec3& origin, const Vec3& direction,
                                  const std::optional<RayDifferentials>& spread,
                                  double t_max) const {
    std::vector<Layer> layers;
    for (const LightSource& source : lights_)
        use_area(source, [&](const auto& light) {
            const auto hit = area_hit(light, origin, direction, spread);
            if (hit && hit->t * (1 - flush) < t_max) layers.push_back({*hit, light.luminance});
        });
    if (layers.empty()) return {};
    std::stable_sort(layers.begin(), layers.end(),
                     [](const Layer& a, const Layer& b) { return a.hit.t < b.hit.t; });
    FrontToBack sum;
    for (const Layer& layer : layers) sum.add(layer.luminance, layer.hit.coverage);
    return {{sum.light, sum.opacity}, layers.front().hit.t};
}

std::vector<Box3> RigAreas::boxes() const {
    std::vector<Box3> boxes;
    for (const LightSource& source : lights_)
        use_area(source, [&](const auto& light) {
            Box3& box = boxes.emplace_back();
            for (const Vec3& corner : bounds_of(light)) box.extend(corner);
        });
    return boxes;
}

} // namespace keiko
