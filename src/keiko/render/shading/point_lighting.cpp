#include "keiko/render/shading/point_lighting.h"

namespace keiko {

std::vector<Rgb> PointLighting::illuminance_by_light(const ClearCoat* coat) const {
    return by_light([&](const LightSource& source, std::span<const int> lamps,
                        std::span<const LightVisibility> seen) {
        return illuminance_by_lamp(source, lamps, seen, rig_.medium, point_, normal_, model_, coat);
    });
}

} // namespace keiko
