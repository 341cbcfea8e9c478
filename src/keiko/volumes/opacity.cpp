#include "keiko/volumes/opacity.h"

#include "keiko/light/luminance/photometry.h"

#include <algorithm>
#include <cmath>

namespace keiko {

double contour_opacity(const ContourOpacity& contour, double value, double gradient) {
    const double away = std::abs(contour.value - value), reach = contour.thickness * gradient;
    if (away == 0) return contour.opacity;
    return away < reach ? contour.opacity * (1 - away / reach) : 0;
}

double region_opacity(const RegionOpacity& region, double value, double gradient) {
    if (!(value >= region.low && value <= region.high)) return 0;
    const double t = (value - region.low) / (region.high - region.low);
    return std::min(1.0, gradient * (region.opacity_high * t + region.opacity_low * (1 - t)));
}

double opacity_of_depth(double optical_depth) {
    return -std::expm1(-optical_depth);
}

double depth_of_opacity(double opacity) {
    constexpr double most = 1 - 1e-4; // so that depths stay finite
    return -std::log1p(-std::min(opacity, most));
}

double node_depth(const VolumeSpec& spec, double step, double value, double gradient) {
    double depth = 0;
    if (!spec.extinction.points.empty()) depth += spec.extinction(value) * metres(step);
    for (const ContourOpacity& contour : spec.contours)
        depth += depth_of_opacity(contour_opacity(contour, value, gradient));
    for (const RegionOpacity& region : spec.regions)
        depth += depth_of_opacity(region_opacity(region, value, gradient));
    return depth;
}

} // namespace keiko
