#pragma once

#include "keiko/light/areas/area_width.h"
#include "keiko/math/quadrature.h"
#include "keiko/math/rgb.h"

#include <vector>

namespace keiko {

// A `Width` is an AreaWidth, or anything else with the members that are called here.

/// Mean over a source of what `of(place)` of its places passes on, weighted by their light on the
/// surface element; 0 for a source that sends none. Gauss's rule of 6 nodes across each part of the
/// width and along each line: to 1e-3 through a coat and a uniform medium of some depths.
template <class Width, class F>
auto mean_over(const Width& width, const F& of) {
    constexpr int nodes = 6;
    decltype(of(Vec3())) sum{};
    double all = 0;
    const auto along = [&](const SubAxis& axis, const ParameterInterval& part, double weight) {
        for (const QuadratureNode& node : gauss_legendre(nodes)) {
            const double half = part.length() / 2, t = part.begin + half * (1 + node.x);
            const double light = weight * half * node.weight * width.light_rate(axis, t);
            sum += of(width.place(axis, t)) * light;
            all += light;
        }
    };
    const std::vector<double> cuts = width.cuts();
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        for (const QuadratureNode& node : gauss_legendre(nodes)) {
            const double half = (cuts[i + 1] - cuts[i]) / 2;
            const SubAxis axis = width.sub_axis(cuts[i] + half * (1 + node.x));
            for (const ParameterInterval& part : width.elevations(axis))
                along(axis, part, axis.weight * half * node.weight);
        }
    return all > 0 ? sum * (1 / all) : sum;
}

} // namespace keiko
