#include "keiko/light/tubes/lamp_ends.h"

#include <cmath>

// A ray that passes a tube's axis at R q in the cross-section enters the tube R sqrt(1 - q^2)
// before it is nearest to the axis, and there it is R q d.y / |d.z| from the plane of the axes,
// both counted along the ray as seen along the lamps.

namespace keiko {

LampEnds LampEnds::of_tubes(const CPlaneFrame& frame, const Vec3& d) {
    const double slope = d.x / std::sqrt(d.y * d.y + d.z * d.z);
    const double bulge = frame.radius() * slope, shear = bulge * d.y / std::abs(d.z);
    if (frame.luminous_caps)
        return {{0, shear, -std::abs(bulge)}, {frame.length, shear, std::abs(bulge)}};
    return {{0, shear, bulge}, {frame.length, shear, bulge}};
}

double end_room(const CPlaneFrame& frame, const Vec3& d) {
    return frame.radius() * std::abs(d.x / d.z);
}

} // namespace keiko
