#include "keiko/light/rig/hidden_lamps.h"

#include "keiko/light/rig/rig_areas.h"
#include "keiko/math/box_corners.h"

#include <algorithm>
#include <string>
#include <vector>

namespace keiko {
namespace {

std::vector<Vec3> places_of(const Box3& box) {
    std::vector<Vec3> places = corners_of(box);
    places.push_back(box.center());
    return places;
}

/// True if another light is before one on the way from a place to a place on it.
bool is_hidden(const RigAreas& areas, std::size_t light, const Vec3& aim, const Vec3& place) {
    constexpr double apart = 1e-3; // of the way: what is nearer is a neighbour, or the light
    const std::vector<RigAreas::Layer> layers = areas.along(place, aim - place, {}, 1);
    return layers.size() > 1 && layers.back().area == light &&
           layers.front().hit.t < layers.back().hit.t * (1 - apart);
}

} // namespace

Diagnostics hidden_lamp_remarks(const LightRig& rig, const Box3& body) {
    if (body.empty()) return {};
    const RigAreas areas(rig);
    const std::vector<Vec3> places = places_of(body);
    const std::vector<std::vector<Vec3>> aims = areas.places();
    std::size_t hidden = 0;
    for (std::size_t light = 0; light < aims.size(); ++light)
        hidden += std::any_of(aims[light].begin(), aims[light].end(), [&](const Vec3& aim) {
            return std::any_of(places.begin(), places.end(), [&](const Vec3& place) {
                return is_hidden(areas, light, aim, place);
            });
        });
    if (hidden == 0) return {};
    const std::string count = std::to_string(hidden) + " of " + std::to_string(aims.size());
    return {{Severity::warning, "lamps",
             count + " panels and other area lights stand behind others as viewed from the body; "
                     "lamps hide nothing, so that surfaces get too much light of them"}};
}

} // namespace keiko
