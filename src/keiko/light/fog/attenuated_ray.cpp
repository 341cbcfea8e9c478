#include "keiko/light/fog/attenuated_ray.h"

#include "keiko/light/fog/transmittance.h"

#include <algorithm>

namespace keiko {

std::vector<double> smooth_pieces(const ParameterInterval& part, std::span<const double> breaks) {
    std::vector<double> ends{part.begin, part.end};
    for (const double t : breaks)
        if (t > part.begin && t < part.end) ends.push_back(t);
    std::sort(ends.begin(), ends.end());
    return ends;
}

AttenuatedRay::AttenuatedRay(const Medium& medium, const Segment& ray)
    : medium_(medium), ray_(ray), breaks_(density_breaks(medium, ray)) {
    const double length = metres((ray.b - ray.a).length());
    const bool even = !std::holds_alternative<GridDensity>(medium.density);
    const auto add_piece = [&](double begin, double end) {
        if (even) even_.push_back(extinction_at(medium, ray.at((begin + end) / 2)) * length);
    };
    Rgb depth;
    double begin = 0;
    for (const double t : breaks_) {
        add_piece(begin, t);
        depth +=
            even ? even_.back() * (t - begin) : optical_depth(medium, {ray.at(begin), ray.at(t)});
        depths_.push_back(depth);
        begin = t;
    }
    add_piece(begin, 1);
}

Rgb AttenuatedRay::depth_to(double t) const {
    const auto next = std::upper_bound(breaks_.begin(), breaks_.end(), t);
    const auto before = static_cast<std::size_t>(next - breaks_.begin());
    const double begin = before == 0 ? 0 : breaks_[before - 1];
    const Rgb known = before == 0 ? Rgb(0) : depths_[before - 1];
    return known + (even_.empty() ? optical_depth(medium_, {ray_.at(begin), ray_.at(t)})
                                  : even_[before] * (t - begin));
}

} // namespace keiko
