#include "keiko/light/fog/transmittance.h"

#include "keiko/base/job.h"

#include <algorithm>
#include <cmath>

namespace keiko {

namespace {

double length_of(const Segment& segment) {
    return (segment.b - segment.a).length();
}

/// Share of the segment above the border.
double share_above(const HeightField& border, const Segment& segment) {
    std::vector<double> ends = crossings(border, segment);
    ends.push_back(1);
    // Alternately above and below.
    bool above = border.above(segment.at(ends.front() / 2)) > 0;
    double sum = 0, begin = 0;
    for (const double end : ends) {
        if (above) sum += end - begin;
        begin = end, above = !above;
    }
    return sum;
}

struct At {
    const Medium& medium;
    const Vec3& point;

    Rgb operator()(const HomogeneousDensity&) const { return medium.extinction; }
    Rgb operator()(const LayeredDensity& layers) const {
        return layers.border.above(point) > 0 ? layers.extinction_above : medium.extinction;
    }
    Rgb operator()(const GridDensity& grid) const {
        return medium.extinction * (*grid.grid)(point);
    }
};

/// Mean density along a segment.
struct Mean {
    const Medium& medium;
    const Segment& segment;

    Rgb operator()(const HomogeneousDensity&) const { return medium.extinction; }
    Rgb operator()(const LayeredDensity& layers) const {
        const double above = share_above(layers.border, segment);
        return layers.extinction_above * above + medium.extinction * (1 - above);
    }
    Rgb operator()(const GridDensity& grid) const {
        check_stop();
        return medium.extinction * grid.grid->mean_along(segment);
    }
};

struct Breaks {
    const Segment& segment;

    std::vector<double> operator()(const HomogeneousDensity&) const { return {}; }
    std::vector<double> operator()(const LayeredDensity& layers) const {
        return crossings(layers.border, segment);
    }
    std::vector<double> operator()(const GridDensity& grid) const {
        return grid.grid->crossings(segment);
    }
};

} // namespace

Rgb extinction_at(const Medium& medium, const Vec3& point) {
    return std::visit(At{medium, point}, medium.density);
}

Rgb optical_depth(const Medium& medium, const Segment& segment) {
    return std::visit(Mean{medium, segment}, medium.density) * metres(length_of(segment));
}

std::vector<double> density_breaks(const Medium& medium, const Segment& segment) {
    return std::visit(Breaks{segment}, medium.density);
}

Rgb transmittance(const Rgb& depth) {
    if (depth.r == depth.g && depth.g == depth.b) return Rgb(std::exp(-depth.g));
    return {std::exp(-depth.r), std::exp(-depth.g), std::exp(-depth.b)};
}

Rgb transmittance(const Medium& medium, const Segment& segment) {
    return transmittance(optical_depth(medium, segment));
}

Rgb ambient_inscatter(const Medium& medium, const Rgb& depth) {
    return medium.ambient *
           Rgb(-std::expm1(-depth.r), -std::expm1(-depth.g), -std::expm1(-depth.b));
}

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
