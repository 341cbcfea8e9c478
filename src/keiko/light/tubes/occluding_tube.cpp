#include "keiko/light/tubes/occluding_tube.h"

#include <algorithm>
#include <cmath>

namespace keiko {

std::array<double, 2> OccludingTube::kinks(double radius) const {
    const double half = std::asin(std::min(radius / distance, 1.0));
    return {angle - half, angle + half};
}

std::vector<ParameterInterval> hidden_elevations(const TubeView& view,
                                                 std::span<const OccludingTube> hiding, double psi,
                                                 double near) {
    std::vector<ParameterInterval> hidden;
    for (const OccludingTube& tube : hiding) {
        const double across = tube.distance * std::sin(psi - tube.angle);
        const double middle = tube.distance * std::cos(psi - tube.angle);
        if (!(std::abs(across) < view.radius)) continue;
        const double half = std::sqrt((view.radius - across) * (view.radius + across));
        const double front = std::max(middle - half, 0.0), back = middle + half;
        if (!(back > 0) || !(front < near)) continue;
        const double begin = view.x_a, end = view.x_a + view.length;
        hidden.push_back({std::min(std::atan2(begin, front), std::atan2(begin, back)),
                          std::max(std::atan2(end, front), std::atan2(end, back))});
    }
    return hidden;
}

} // namespace keiko
