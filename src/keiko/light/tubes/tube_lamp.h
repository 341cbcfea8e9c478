#pragma once

#include "keiko/light/tubes/c_plane_frame.h"

#include <vector>

namespace keiko {

/// A straight matt tube: `luminance` is the same in every direction.
struct TubeLamp {
    Vec3 a{0}, b{0};            ///< ends of the axis, mm
    double diameter = 0;        ///< mm
    Rgb luminance;              ///< cd/m2 of the lateral surface
    bool luminous_caps = false; ///< whether the end discs shine alike; else they are dark
};

/// Lamp `index`, 0 to lamps - 1, of the comb.
inline TubeLamp lamp_of(const CPlaneFrame& frame, int index, const Rgb& luminance) {
    const double across = frame.axis(index);
    return {frame.at(0, across), frame.at(frame.length, across), frame.diameter, luminance,
            frame.luminous_caps};
}

/// All lamps of a C-plane by rising v.
inline std::vector<TubeLamp> lamps_of(const CPlane& plane) {
    const CPlaneFrame frame(plane);
    std::vector<TubeLamp> lamps;
    lamps.reserve(static_cast<std::size_t>(frame.lamps));
    for (int i = 0; i < frame.lamps; ++i) lamps.push_back(lamp_of(frame, i, plane.luminance));
    return lamps;
}

} // namespace keiko
