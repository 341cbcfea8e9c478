#pragma once

#include "keiko/light/areas/area_width.h"
#include "keiko/math/quadrature.h"
#include "keiko/math/rgb.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {

/// Mean over a source of what `of(place)` of its places passes on, weighted by their light on the
/// surface element; 0 for a source that sends none. Gauss's rule of 6 nodes across each part of the
/// width and along each line: to 1e-3 through a coat and a uniform medium of some depths.
template <class F>
auto mean_over(const AreaWidth& width, const F& of) {
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

/// Integral of a kernel (GlossKernel, FlakeKernel) over the directions to a source above the
/// horizon. Times the source's luminance it is the luminance that the surface reflects to the
/// viewer. Gauss's and Kronrod's rules in wedge angle and elevation, cut about the kernel's peak,
/// halved until they agree within `relative` of the whole.
template <class Kernel>
Rgb gloss_integral(const AreaWidth& width, const Kernel& kernel, double relative) {
    const double spread = kernel.spread();
    const auto in_half_plane = [&](double place) {
        const SubAxis axis = width.sub_axis(place);
        const Vec3 level = width.direction(axis, 0), along = width.direction(axis, 1);
        const double crest = std::atan2(kernel.peak().dot(along), kernel.peak().dot(level));
        Rgb sum;
        for (const ParameterInterval& part : width.elevations(axis)) {
            Breakpoints range(2 * std::atan(part.begin), 2 * std::atan(part.end));
            for (const double off : {-4.0, -1.5, -0.5, 0.5, 1.5, 4.0})
                range.cut_at(crest + off * spread);
            sum += integrate_paired(
                [&](double eta) {
                    return kernel(level * std::cos(eta) + along * std::sin(eta)) * std::cos(eta);
                },
                range, relative, 4);
        }
        return sum * axis.weight;
    };
    Rgb sum;
    const std::vector<double> cuts = width.cuts();
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
        Breakpoints range(cuts[i], cuts[i + 1]);
        const double crest = width.place_in(kernel.peak());
        const double rate = std::max(width.sub_axis(std::clamp(crest, -0.9, 0.9)).weight, 1e-12);
        for (const double off : {-4.0, -1.5, -0.5, 0.5, 1.5, 4.0})
            range.cut_at(crest + off * spread / rate);
        sum += integrate_paired(in_half_plane, range, relative, 4);
    }
    return sum;
}

} // namespace keiko
