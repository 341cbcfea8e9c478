#include "keiko/render/shading/lit_point.h"

namespace keiko {

std::vector<Rgb> LitPoint::illuminance_by_light(const ClearCoat* coat) const {
    return by_light([&](const LightSource& source, std::span<const int> lamps,
                        std::span<const SeenLight> seen) {
        return illuminance_by_lamp(source, lamps, seen, rig_.medium, point_, normal_, model_, coat);
    });
}

} // namespace keiko
