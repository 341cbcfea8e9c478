#pragma once

#include "keiko/render/lit_spot.h"
#include "keiko/render/pixel_rectangle.h"

namespace keiko {

/// How far a place lies from `begin` to `end`, 0 to 1.
inline double share_of_way(int begin, int end, int at) {
    return end > begin ? static_cast<double>(at - begin) / (end - begin) : 0;
}

/// Light at the corners of a rectangle, linear between them.
struct LinearLight {
    Rectangle of;
    std::array<SpotLight, 4> corners{};

    SpotLight at(const Pixel& p) const {
        const double s = share_of_way(of.x0, of.x1, p.x), t = share_of_way(of.y0, of.y1, p.y);
        return (corners[0] * (1 - s) + corners[1] * s) * (1 - t) +
               (corners[2] * (1 - s) + corners[3] * s) * t;
    }
    LinearLight part(const Rectangle& r) const {
        LinearLight part{r};
        for (std::size_t i = 0; i < 4; ++i) part.corners[i] = at(r.corners()[i]);
        return part;
    }
};

} // namespace keiko
