#include "keiko/light/rig/prepared_rig.h"

#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/sky/sky_panels.h"
#include "keiko/light/spotlight/point_light.h"
#include "keiko/light/tubes/c_plane_lookup.h"

#include <cmath>
#include <numeric>
#include <type_traits>

namespace keiko {

PreparedSource::Kind PreparedSource::prepare(const LightSource& source) {
    return std::visit(
        [](const auto& kind) -> Kind {
            if constexpr (std::is_same_v<std::decay_t<decltype(kind)>, CPlane>)
                return LampRow(kind);
            else
                return kind;
        },
        source);
}

std::vector<int> PreparedSource::lamp_numbers() const {
    const auto* row = std::get_if<LampRow>(&kind_);
    const auto* sky = std::get_if<SkyLight>(&kind_);
    const int count = row ? row->frame.lamps : sky ? panel_count(*sky) : 1;
    std::vector<int> numbers(static_cast<std::size_t>(count));
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

PreparedRig::PreparedRig(const LightRig& rig)
    : sources(rig.sources.begin(), rig.sources.end()), medium(rig.medium) {
    for (std::size_t i = 0; i < sources.size(); ++i)
        for (const int lamp : sources[i].lamp_numbers()) lights.push_back({i, lamp});
}

namespace {

/// Distance from the glass, as a share of a tube's radius, within which points count as on it.
constexpr double rounding = 1e-9;

struct Holds {
    const Vec3& point;

    bool operator()(const LampRow& row) const {
        const CPlaneFrame& frame = row.frame;
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
    bool operator()(const SkyLight&) const { return false; }
    template <ExtendedLight Light>
    bool operator()(const Light& light) const {
        return holds(light, point);
    }
};

} // namespace

bool within_lamp(const PreparedSource& source, const Vec3& point) {
    return std::visit(Holds{point}, source.kind());
}

} // namespace keiko
