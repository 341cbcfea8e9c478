#pragma once

#include "keiko/light/luminance/gloss_slice.h"
#include "keiko/light/sky/sky_panels.h"
#include "keiko/math/quadrature.h"
#include "keiko/math/rgb.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace keiko {

/// Integral of a kernel over the directions to a panel of the sky above the horizon in the
/// half-plane of a line, by the wedge angle.
template <class Kernel>
Rgb gloss_in_half_plane(const SkyWidth& width, const SubAxis& axis, const Kernel& kernel,
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

/// Integral of a kernel (GlossKernel, FlakeKernel) over the directions to a panel of the sky above
/// the horizon. Times the panel's luminance it is the luminance that the surface reflects to the
/// viewer. Gauss's and Kronrod's rules in wedge angle and elevation, cut about the kernel's peak,
/// are halved until they agree within `relative` of the whole.
template <class Kernel>
Rgb gloss_integral(const SkyWidth& width, const Kernel& kernel, double relative) {
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
