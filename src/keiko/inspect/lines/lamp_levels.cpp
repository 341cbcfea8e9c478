#include "keiko/inspect/lines/lamp_levels.h"

#include <cmath>
#include <numbers>

namespace keiko {

double LampLevels::step(std::uint32_t lamp) const {
    if (lamps < 2) return 0;
    const std::uint32_t from = lamp + 1 < lamps ? lamp : lamp - 1;
    return std::abs(levels[from + 1] - levels[from]);
}

LampLevels lamp_levels(LineLook look, const LineEye& eye, const CPlane& plane, const Vec3& body) {
    LampLevels lamps{LineField(look, eye, plane, body), {}, 0};
    const CPlaneFrame& frame = lamps.field.plane();
    lamps.lamps = static_cast<std::uint32_t>(frame.lamps);
    for (int i = 0; i < frame.lamps; ++i)
        lamps.levels.push_back(look == LineLook::isophote
                                   ? std::cos(std::numbers::pi / 2 * (i + 0.5) / frame.lamps)
                                   : frame.axis(i));
    if (look == LineLook::isophote)
        for (std::uint32_t i = 0; i < lamps.lamps; ++i) lamps.levels.push_back(-lamps.levels[i]);
    return lamps;
}

} // namespace keiko
