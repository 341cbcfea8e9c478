#include "keiko/fog/dimmed_ray.h"

#include "keiko/fog/transmittance.h"

#include <algorithm>

namespace keiko {

std::vector<double> smooth_pieces(const ParameterInterval& part, std::span<const double> breaks) {
    std::vector<double> ends{part.begin, part.end};
    for (const double t : breaks)
        if (t > part.begin && t < part.end) ends.push_back(t);
    std::sort(ends.begin(), ends.end());
    return ends;
}

DimmedRay::DimmedRay(const Medium& medium, const Segment& ray)
    : medium_(medium), ray_(ray), breaks_(density_breaks(medium, ray)) {
    if (std::holds_alternative<EvenDensity>(medium.density)) even_ = optical_depth(medium, ray);
    Rgb depth;
    double begin = 0;
    for (const double t : breaks_) {
        depth += optical_depth(medium, {ray.at(begin), ray.at(t)});
        depths_.push_back(depth);
        begin = t;
    }
}

Rgb DimmedRay::depth_to(double t) const {
    if (std::holds_alternative<EvenDensity>(medium_.density)) return even_ * t;
    const auto next = std::upper_bound(breaks_.begin(), breaks_.end(), t);
    if (next == breaks_.begin()) return optical_depth(medium_, {ray_.a, ray_.at(t)});
    const auto last = static_cast<std::size_t>(next - breaks_.begin()) - 1;
    return depths_[last] + optical_depth(medium_, {ray_.at(breaks_[last]), ray_.at(t)});
}

} // namespace keiko
