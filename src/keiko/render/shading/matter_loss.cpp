#include "keiko/render/shading/matter_loss.h"

#include "keiko/render/shading/lamp_places.h"

#include <cmath>

namespace keiko {

double MatterLoss::passed(const Segment& way) const {
    constexpr double darkness = 20; // optical depth that no light counts beyond
    double depth = 0;
    if (volumes_) depth += volumes_->optical_depth(way, darkness);
    if (texels_ && depth < darkness) depth += texels_->optical_depth(way, darkness);
    return std::exp(-depth);
}

double MatterLoss::left(const PreparedSource& source, int lamp, const Vec3& point) const {
    double sum = 0, weights = 0;
    for (const LampPlace& from : lamp_places(source, lamp, point)) {
        sum += passed({point, from.place}) * from.weight;
        weights += from.weight;
    }
    return weights > 0 ? sum / weights : 1;
}

} // namespace keiko
