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

/// True if one light is before another on the way from a place to the middle of the farther one.
bool is_hidden(const RigAreas& areas, const Vec3& middle, const Vec3& place) {
    constexpr double apart = 1e-3; // of the way: what is nearer is one light, or its neighbour
    const std::vector<RigAreas::Layer> layers = areas.along(place, middle - place, {}, 1);
    return layers.size() > 1 && layers.front().hit.t < layers.back().hit.t * (1 - apart);
}

} // namespace

Diagnostics hidden_lamp_remarks(const LightRig& rig, const Box3& body) {
    if (body.empty()) return {};
    const RigAreas areas(rig);
    const std::vector<Vec3> places = places_of(body);
    const std::vector<Box3> boxes = areas.boxes();
    const auto hidden = std::count_if(boxes.begin(), boxes.end(), [&](const Box3& box) {
        return std::any_of(places.begin(), places.end(), [&](const Vec3& place) {
            return is_hidden(areas, box.center(), place);
        });
    });
    if (hidden == 0) return {};
    const std::string count = std::to_string(hidden) + " of " + std::to_string(boxes.size());
    return {{Severity::warning, "lamps",
             count + " panels and other area lights stand behind others as viewed from the body; "
                     "lamps hide nothing, so that surfaces get too much light of them"}};
}

} // namespace keiko
