#include "keiko/light/tubes/lobe_reach.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

LampRange lamps_in_cone(const CPlaneFrame& frame, const Vec3& point, const Vec3& axis,
                        double half_angle) {
    const LampRange all{0, frame.lamps};
    // Tubes reach out of the plane by their radius: a wider cone than at the plane.
    const Vec3 at = frame.point(point), r = frame.vector(axis);
    const double height = std::abs(at.z) + frame.radius();
    const double towards = at.z > 0 ? -r.z : r.z;
    if (!(half_angle < std::numbers::pi / 2) || !(towards > 0)) return all;
    const double c = std::cos(half_angle), k = r.x * r.x + r.y * r.y - c * c;
    const double square =
        towards * towards * r.y * r.y - k * (towards * towards + r.x * r.x - c * c);
    if (!(k < 0) || !(square >= 0)) return all;
    const double a = (-towards * r.y + std::sqrt(square)) / k;
    const double b = (-towards * r.y - std::sqrt(square)) / k;
    const double margin = frame.radius() * (1 + std::hypot(a, b));
    const double low = at.y + height * std::min(a, b) - margin;
    const double high = at.y + height * std::max(a, b) + margin;
    const double first = std::ceil((low - frame.first) / frame.pitch);
    const double last = std::floor((high - frame.first) / frame.pitch);
    return {static_cast<int>(std::clamp(first, 0.0, frame.lamps * 1.0)),
            static_cast<int>(std::clamp(last + 1, 0.0, frame.lamps * 1.0))};
}

} // namespace keiko
