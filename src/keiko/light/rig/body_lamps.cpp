#include "keiko/light/rig/body_lamps.h"

#include <algorithm>
#include <iterator>

namespace keiko {

bool is_body_lamp(const LightSource& source) {
    const auto* panel = std::get_if<PolygonLight>(&source);
    return std::holds_alternative<ContourLight>(source) || (panel && !panel->shown);
}

bool shines_by_bodies_alone(const LightRig& rig) {
    return rig.ambient == Rgb(0) &&
           std::all_of(rig.sources.begin(), rig.sources.end(), is_body_lamp);
}

void add_body_lamps(const std::optional<LightRig>& from, LightRig& to) {
    if (!from) return;
    std::copy_if(from->sources.begin(), from->sources.end(), std::back_inserter(to.sources),
                 is_body_lamp);
}

void move_body_lamps(const Affine& motion, LightRig& rig) {
    for (LightSource& source : rig.sources) {
        if (!is_body_lamp(source)) continue;
        if (auto* light = std::get_if<ContourLight>(&source)) {
            light->body = light->body->moved(motion);
            continue;
        }
        std::vector<Vec3>& corners = std::get<PolygonLight>(source).corners;
        for (Vec3& corner : corners) corner = motion.point(corner);
        if (motion.mirrored()) std::reverse(corners.begin(), corners.end());
    }
}

} // namespace keiko
