#pragma once

#include "keiko/math/adaptive_quadrature.h"
#include "keiko/tubes/tube_slices.h"

#include <array>

namespace keiko {

/// How finely lobes are integrated over lamps.
enum class GlossQuadrature {
    picture, ///< fixed nodes: about 3e-4 of a lamp in ordinary position
    number   ///< halved until 1e-9 of the lamp is reached
};

/// A range in the pieces between some places.
class CutRange {
public:
    CutRange(double begin, double end) : begin_(begin), end_(end) {}

    /// Up to 8 places; those outside of the range do not count.
    void cut_at(double x) {
        if (!(x > begin_ && x < end_) || count_ == cuts_.size()) return;
        std::size_t at = count_++;
        for (; at > 0 && cuts_[at - 1] > x; --at) cuts_[at] = cuts_[at - 1];
        cuts_[at] = x;
    }
    /// Sum of `f(a, b)` over the pieces from begin to end.
    template <class F>
    Rgb sum(const F& f) const {
        Rgb total;
        double from = begin_;
        for (std::size_t i = 0; i <= count_; ++i) {
            const double to = i < count_ ? cuts_[i] : end_;
            if (from < to) total += f(from, to);
            from = to;
        }
        return total;
    }

private:
    double begin_, end_;
    std::array<double, 8> cuts_{};
    std::size_t count_ = 0;
};

/// Integral of a kernel (GlossKernel, FlakeKernel) over the directions to a part of a lamp: times
/// the lamp's luminance, what the surface sends to the eye. Quadrature in the wedge variables of
/// physics 5.6, cut about the kernel's peak.
template <class Kernel>
class TubeGloss {
public:
    TubeGloss(const TubeSlices& slices, const Kernel& kernel) : slices_(slices), kernel_(kernel) {
        const TubeView& view = slices.view();
        const Vec3& peak = kernel.peak();
        along_ = view.along.dot(peak);
        psi_ = std::atan2(view.sideways.dot(peak), -view.towards.dot(peak));
        // Meridians crowd at the ends of the axis.
        const double across = std::sqrt(std::max(0.0, 1 - along_ * along_));
        psi_spread_ = kernel.spread() / std::max(across, 0.05);
    }

    Rgb integral(GlossQuadrature quadrature) const {
        return quadrature == GlossQuadrature::picture ? fixed() : refined();
    }

private:
    /// With few nodes across the lamp, fewest where it is narrow beside the lobe and whole.
    Rgb fixed() const {
        const double half = slices_.half_angle();
        const bool easy = half < 0.1 * psi_spread_ && !slices_.crosses_horizon();
        const int nodes = easy ? 2 : 4;
        CutRange wedge(-half, half);
        if (psi_spread_ < half)
            for (const double step : {-1.5, -0.5, 0.5, 1.5})
                wedge.cut_at(psi_ + step * psi_spread_);
        const auto slice = [&](double psi) {
            return slice_sum(psi, kernel_.spread() > wide, [](const auto& f, double a, double b) {
                return integrate(f, a, b, nodes_along);
            });
        };
        return wedge.sum([&](double a, double b) { return integrate(slice, a, b, nodes); });
    }

    /// In the angle that makes the outline smooth: sin psi = sin(half) sin t.
    Rgb refined() const {
        const double sine_limit = std::sin(slices_.half_angle()), quarter = std::numbers::pi / 2;
        const double scale = largest_part(fixed());
        if (scale == 0 && !near_peak()) return {};
        const double allowed = refinement * std::max(scale, 1e-300);
        const auto slice = [&](double t) {
            const double psi = std::asin(sine_limit * std::sin(t));
            const double rate = sine_limit * std::cos(t) / std::cos(psi);
            const double inner = allowed / std::max(rate, 1e-6) / 8;
            return rate * slice_sum(psi, false, [&](const auto& f, double a, double b) {
                       return integrate_adaptively(f, a, b, inner);
                   });
        };
        CutRange wedge(-quarter, quarter);
        wedge.cut_at(0);
        for (const double step : {-1.5, -0.5, 0.5, 1.5}) {
            const double sine = std::sin(psi_ + step * psi_spread_) / sine_limit;
            if (std::abs(sine) < 1) wedge.cut_at(std::asin(sine));
        }
        return wedge.sum(
            [&](double a, double b) { return integrate_adaptively(slice, a, b, allowed); });
    }

    bool near_peak() const { return std::abs(psi_) < slices_.half_angle() + psi_spread_; }

    /// Over the elevations of one half-plane, by `rule`, cut about the peak; in fewer pieces if
    /// `coarse`.
    template <class Rule>
    Rgb slice_sum(double psi, bool coarse, const Rule& rule) const {
        const ParameterInterval range = slices_.elevations(psi);
        if (!(range.begin < range.end)) return {};
        const Vec3 across = slices_.across(psi), along = slices_.view().along;
        const double highest = std::atan2(along_, across.dot(kernel_.peak()));
        const auto f = [&](double eta) {
            const double cosine = std::cos(eta);
            return kernel_(across * cosine + along * std::sin(eta)) * cosine;
        };
        CutRange elevations(range.begin, range.end);
        const double spread = kernel_.spread();
        if (coarse)
            for (const double step : {-1.0, 1.0}) elevations.cut_at(highest + step * spread);
        else
            for (const double step : {-2.0, -0.7, 0.7, 2.0})
                elevations.cut_at(highest + step * spread);
        return elevations.sum([&](double a, double b) { return rule(f, a, b); });
    }

    static constexpr int nodes_along = 8;
    static constexpr double wide = 0.5; ///< radians; a lobe wider than that needs fewer pieces
    static constexpr double refinement = 1e-9;

    const TubeSlices& slices_;
    const Kernel& kernel_;
    double along_ = 0;      ///< component of the peak along the axis
    double psi_ = 0;        ///< wedge angle of the peak
    double psi_spread_ = 0; ///< the kernel's spread in that angle
};

} // namespace keiko
