#include "keiko/render/shading/texel_light.h"

namespace keiko {
namespace {

/// Direction to the middle of a lamp; of any length.
Vec3 middle_of(const PreparedSource& source, int lamp, const Vec3& place) {
    Vec3 sum(0);
    for (const Vec3& corner : lamp_corners(source, lamp, place, TubeModel::preview))
        sum += (corner - place).normalized();
    return sum;
}

} // namespace

std::vector<ArrivingLight> arriving_lights(const PreparedRig& rig, const DirectLighting& lights,
                                           const LossBeforeTexels& loss, TubeModel tubes,
                                           const Vec3& place) {
    std::vector<ArrivingLight> all;
    all.reserve(rig.lights.size());
    for (const LightId& id : rig.lights) {
        const PreparedSource& source = rig.sources[id.source];
        const Vec3 towards = middle_of(source, id.lamp, place);
        all.emplace_back();
        if (!(towards.length() > 0) || within_lamp(source, place)) continue;
        ArrivingLight& light = all.back();
        light.towards = towards.normalized();
        const PointLighting lit(rig, place, light.towards, tubes, {&id, 1},
                                lights.light_visibility(place, light.towards, {}, {&id, 1}, tubes));
        light.illuminance = lit.illuminance_by_light().front();
        if (light.illuminance == Rgb(0)) continue;
        if (loss.glass) light.illuminance *= loss.glass->left(source, id.lamp, place, {});
        if (loss.matter.any()) light.illuminance *= loss.matter.left(source, id.lamp, place);
    }
    return all;
}

} // namespace keiko
