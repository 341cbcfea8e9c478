#include "keiko/light/fog/transmittance.h"

#include "keiko/base/job.h"

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
    // By turns above and below.
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

/// Mean along a segment.
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

} // namespace keiko
