#pragma once

#include "keiko/light/luminance/gloss_kernel.h"
#include "keiko/math/interval_set.h"
#include "keiko/math/quadrature.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keiko {

/// A range cut about the peak of a lobe, whose spread is in the range's unit.
inline Breakpoints about_peak(double begin, double end, double peak, double spread) {
    Breakpoints range(begin, end);
    for (const double off : {-4.0, -1.5, -0.5, 0.5, 1.5, 4.0}) range.cut_at(peak + off * spread);
    return range;
}

/// A half-plane of directions from a point: the integral of a kernel over the elevations that a
/// source occupies there, by the wedge angle, cut about the lobe's crest.
template <class Kernel>
class GlossSlice {
public:
    /// `along`: unit vector along the source and along the edge of the half-plane; `across`: the
    /// unit vector at elevation 0 in it. References to `along` and the kernel are kept.
    GlossSlice(const Vec3& along, const Vec3& across, const Kernel& kernel, const LobeChart& chart)
        : along_(along), across_(across), kernel_(kernel) {
        find_crest(chart);
    }

    /// Integral to about 3e-4, by pairs of rules that estimate their error. `range` in radians.
    Rgb for_picture(const ParameterInterval& range) const {
        return paired(range, picture_error, [](double) { return Rgb(1); });
    }
    /// Integral by pairs of rules that agree within `relative` of it, times what `passed(eta)` of
    /// the light under an elevation arrives.
    template <class Passed>
    Rgb paired(const ParameterInterval& range, double relative, const Passed& passed) const {
        if (!(range.begin < range.end)) return {};
        return integrate_paired(
            [&](double eta) {
                const Rgb sent = sent_at(eta);
                return sent == Rgb() ? sent : sent * passed(eta);
            },
            cut(range, {1.5, 5}), relative);
    }
    /// Integral, halved until `allowed` is reached.
    Rgb as_number(const ParameterInterval& range, double allowed) const {
        if (!(range.begin < range.end)) return {};
        return sum_over_pieces(cut(range, {0.7, 2}), [&](double a, double b) {
            return integrate_adaptively([this](double eta) { return sent_at(eta); }, a, b, allowed);
        });
    }

private:
    /// Finds the place in the half-plane that lies fewest spreads from the peak, by two
    /// Gauss-Newton steps from the one at the least angle.
    void find_crest(const LobeChart& chart) {
        constexpr double furthest = 0.5; // radians a step
        crest_ = std::atan2(along_.dot(chart.peak()), across_.dot(chart.peak()));
        for (int step = 0; step < 2; ++step) {
            const Vec3 turn = along_ * std::cos(crest_) - across_ * std::sin(crest_);
            const auto [off, rate] = chart.at(direction(crest_), turn);
            const double square = rate.length2();
            spread_ = 1 / std::sqrt(square);
            crest_ -= std::clamp(off.dot(rate) / square, -furthest, furthest);
        }
    }
    Vec3 direction(double eta) const { return across_ * std::cos(eta) + along_ * std::sin(eta); }
    /// Kernel by the wedge angle and the elevation.
    Rgb sent_at(double eta) const {
        const double cosine = std::cos(eta);
        return kernel_(across_ * cosine + along_ * std::sin(eta)) * cosine;
    }
    Breakpoints cut(const ParameterInterval& range, const std::array<double, 2>& spreads) const {
        Breakpoints cut(range.begin, range.end);
        for (const double step : spreads) {
            cut.cut_at(crest_ - step * spread_);
            cut.cut_at(crest_ + step * spread_);
        }
        return cut;
    }

    static constexpr double picture_error = 3e-3; ///< that the coarser rule may have

    const Vec3& along_;
    Vec3 across_;
    const Kernel& kernel_;
    double crest_ = 0;  ///< elevation
    double spread_ = 0; ///< of the lobe along the half-plane, radians
};

} // namespace keiko
