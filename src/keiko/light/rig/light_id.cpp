#include "keiko/light/rig/light_id.h"

#include "keiko/light/spotlight/point_light.h"
#include "keiko/light/tubes/c_plane_lookup.h"

#include <cmath>
#include <numeric>

namespace keiko {

std::vector<int> lamp_numbers(const LightSource& source) {
    const auto* row = std::get_if<CPlane>(&source);
    std::vector<int> numbers(row ? static_cast<std::size_t>(row->lamps) : 1);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

std::vector<LightId> lights_of(const LightRig& rig) {
    std::vector<LightId> lights;
    for (std::size_t i = 0; i < rig.sources.size(); ++i)
        for (const int lamp : lamp_numbers(rig.sources[i])) lights.push_back({i, lamp});
    return lights;
}

namespace {

/// Distance from the glass, as a share of a tube's radius, within which points count as on it.
constexpr double rounding = 1e-9;

struct Holds {
    const Vec3& point;

    bool operator()(const CPlane& plane) const {
        const CPlaneFrame frame(plane);
        const Vec3 at = frame.point(point);
        const auto nearest = strip_at(frame, at.x, at.y, frame.diameter);
        return nearest &&
               std::hypot(at.y - frame.axis(*nearest), at.z) < frame.radius() * (1 - rounding);
    }
    template <PointLight Light>
    bool operator()(const Light& light) const {
        return light.position == point;
    }
    bool operator()(const Sun&) const { return false; }
};

} // namespace

bool within_lamp(const LightSource& source, const Vec3& point) {
    return std::visit(Holds{point}, source);
}

} // namespace keiko
