#pragma once

#include "keiko/light/luminance/lobe_chart.h"
#include "keiko/light/tubes/tube_slices.h"
#include "keiko/math/quadrature.h"

namespace keiko {

/// One half-plane through a lamp: the integral of a kernel over the elevations that the lamp takes
/// there, cut about the lobe's crest.
template <class Kernel>
class GlossSlice {
public:
    /// All are only looked at.
    GlossSlice(const TubeSlices& slices, const Kernel& kernel, const LobeChart& chart, double psi)
        : along_(slices.view().along), across_(slices.across(psi)), kernel_(kernel) {
        find_crest(chart);
    }

    /// To about 3e-4, by pairs of rules that tell their error.
    Rgb for_picture(const ParameterInterval& range) const {
        return range.begin < range.end
                   ? integrate_paired(integrand(), cut(range, {1.5, 5}), picture_error)
                   : Rgb();
    }
    /// Halved until `allowed` is reached.
    Rgb as_number(const ParameterInterval& range, double allowed) const {
        if (!(range.begin < range.end)) return {};
        return sum_over_pieces(cut(range, {0.7, 2}), [&](double a, double b) {
            return integrate_adaptively(integrand(), a, b, allowed);
        });
    }

private:
    /// The place in the half-plane that lies fewest spreads off the peak, by two steps of Gauss and
    /// Newton's from the one at the least angle.
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
    auto integrand() const {
        return [this](double eta) {
            const double cosine = std::cos(eta);
            return kernel_(across_ * cosine + along_ * std::sin(eta)) * cosine;
        };
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
