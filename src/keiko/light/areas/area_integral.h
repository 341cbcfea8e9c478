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

/// A range cut about the peak of a lobe, whose spread is in the range's unit.
inline Breakpoints about_peak(double begin, double end, double peak, double spread) {
    Breakpoints range(begin, end);
    for (const double off : {-4.0, -1.5, -0.5, 0.5, 1.5, 4.0}) range.cut_at(peak + off * spread);
    return range;
}

/// Integral of a kernel over the directions to a source above the horizon in the half-plane of a
/// line, by the wedge angle.
template <class Kernel>
Rgb gloss_in_half_plane(const AreaWidth& width, const SubAxis& axis, const Kernel& kernel,
                        double relative) {
    const Vec3 level = width.direction(axis, 0), along = width.direction(axis, 1);
    const double peak = std::atan2(kernel.peak().dot(along), kernel.peak().dot(level));
    const auto sent = [&](double eta) {
        return kernel(level * std::cos(eta) + along * std::sin(eta)) * std::cos(eta);
    };
    Rgb sum;
    for (const ParameterInterval& part : width.elevations(axis))
        sum += integrate_paired(
            sent,
            about_peak(2 * std::atan(part.begin), 2 * std::atan(part.end), peak, kernel.spread()),
            relative);
    return sum;
}

/// Integral of a kernel (GlossKernel, FlakeKernel) over the directions to a source above the
/// horizon. Times the source's luminance it is the luminance that the surface reflects to the
/// viewer. Gauss's and Kronrod's rules in wedge angle and elevation, cut about the kernel's peak,
/// are halved until they agree within `relative` of the whole.
template <class Kernel>
Rgb gloss_integral(const AreaWidth& width, const Kernel& kernel, double relative) {
    const double peak = width.place_in(kernel.peak());
    constexpr double flank = 0.9; // of the width: at its end a sphere's rate is 0
    const double rate = width.sub_axis(std::clamp(peak, -flank, flank)).weight;
    const auto sent = [&](double place) {
        const SubAxis axis = width.sub_axis(place);
        return gloss_in_half_plane(width, axis, kernel, relative) * axis.weight;
    };
    Rgb sum;
    const std::vector<double> cuts = width.cuts();
    for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
        sum += integrate_paired(
            sent, about_peak(cuts[i], cuts[i + 1], peak, kernel.spread() / rate), relative);
    return sum;
}

} // namespace keiko
