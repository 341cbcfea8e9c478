#pragma once

#include "keiko/light/luminance/gloss_slice.h"
#include "keiko/light/tubes/tube_slices.h"
#include "keiko/math/quadrature.h"

namespace keiko {

/// Accuracy with which lobes are integrated over lamps.
enum class GlossQuadrature {
    picture, ///< few half-planes: 2.3e-3 of what a lamp gives, 4e-3 of the narrowest lobes
    number   ///< halved until 1e-9 of the lamp is reached
};

/// Integral of a kernel (GlossKernel, FlakeKernel) over the directions to a part of a lamp; times
/// the lamp's luminance it is the luminance that the surface reflects to the viewer. Quadrature in
/// wedge angle and elevation (docs/theory/luminance.md#lobes), cut about the kernel's peak.
template <class Kernel>
class TubeGloss {
public:
    /// Prepares the integral: measures the lobe at the part's nearest place to the peak. References
    /// to both are kept.
    TubeGloss(const TubeSlices& slices, const Kernel& kernel)
        : slices_(slices),
          kernel_(kernel),
          chart_(kernel.chart()),
          half_(slices.half_angle()),
          psi_(std::atan2(slices.view().sideways.dot(chart_.peak()),
                          -slices.view().towards.dot(chart_.peak()))) {
        approach();
    }

    /// Integral of the kernel over the solid angle of the part above the horizon: a share of the
    /// lamp's luminance.
    Rgb integral(GlossQuadrature quadrature) const {
        return quadrature == GlossQuadrature::picture ? for_picture() : as_number();
    }

private:
    /// Bounds within which a rule of few half-planes is accurate enough.
    struct Reach {
        double width; ///< of the lamp's half, in spreads of the lobe
        double dip;   ///< see TubeSlices::dip()
        double steep; ///< of the flank at the rims
        double ratio; ///< d / D
    };
    /// Limits of Gauss's rules of 1, 2 and 4 half-planes. Their errors are of order width^2, ^4 and
    /// ^8 with factors of about 0.5, 0.2 and 0.02 where the lobe is steepest, and likewise of
    /// dip^2, ^4 and ^8. The error of the rims' mean is of order (d/D)^2.
    static constexpr Reach one{0.02, 0.05, 0.1, 0.1}, two{0.08, 0.15, 0.1, 0.2},
        four{0.4, 0.15, 0.35, 0.2};
    /// Difference of half-planes beyond which more of them are needed.
    static constexpr double steepest = 0.2;

    bool within(const Reach& reach) const {
        return half_ < reach.width * psi_spread_ && slices_.dip() < reach.dip &&
               steep_ < reach.steep && slices_.view().ratio() < reach.ratio;
    }

    Rgb for_picture() const {
        if (slices_.whole() && within(one)) return at(width_quadrature(1)[0]) * (2 * half_);
        if (slices_.whole() && within(two)) {
            const Rgb left = at(width_quadrature(2)[0]), right = at(width_quadrature(2)[1]);
            if (largest_part(left - right) < steepest * largest_part(left + right))
                return (left + right) * half_;
        }
        if (!within(four)) return across_adaptively();
        Rgb sum;
        for (const AcrossNode& node : width_quadrature(4)) sum += at(node) * (node.weight * half_);
        return sum;
    }
    GlossSlice<Kernel> slice(double psi) const {
        return {slices_.view().along, slices_.across(psi), kernel_, chart_};
    }
    Rgb at(const AcrossNode& node) const {
        const double psi = half_ * node.x;
        return slice(psi).for_picture(slices_.elevations(psi, node.rim * slices_.view().radius));
    }
    Rgb across_adaptively() const {
        return integrate_paired(over_outline([](const auto& slice, const auto& range, double) {
                                    return slice.for_picture(range);
                                }),
                                outline(), picture_error);
    }
    Rgb as_number() const {
        const double scale = largest_part(across_adaptively());
        if (scale == 0 && std::abs(psi_) > half_ + psi_spread_) return {};
        const double allowed = refinement * std::max(scale, 1e-300);
        const auto sent = over_outline([&](const auto& slice, const auto& range, double rate) {
            return slice.as_number(range, allowed / std::max(rate, 1e-6) / 8);
        });
        return sum_over_pieces(outline(), [&](double a, double b) {
            return integrate_adaptively(sent, a, b, allowed);
        });
    }

    /// Integral of `of_slice` of a half-plane by the angle t that makes the outline smooth, sin psi
    /// = sin(half) sin t, times the rate of psi.
    template <class OfSlice>
    auto over_outline(OfSlice of_slice) const {
        return [this, of_slice, limit = std::sin(half_)](double t) {
            const double psi = std::asin(limit * std::sin(t));
            const double rate = limit * std::cos(t) / std::cos(psi);
            return of_slice(slice(psi), slices_.elevations(psi), rate) * rate;
        };
    }
    /// Range of t, cut about the peak.
    Breakpoints outline() const {
        const double quarter = std::numbers::pi / 2, limit = std::sin(half_);
        Breakpoints range(-quarter, quarter);
        range.cut_at(0);
        for (const double step : {-1.5, -0.5, 0.5, 1.5}) {
            const double psi = psi_ + step * psi_spread_, sine = std::sin(psi) / limit;
            if (std::abs(psi) < quarter && std::abs(sine) < 1) range.cut_at(std::asin(sine));
        }
        return range;
    }
    /// Measures the lobe at the part's nearest place to the peak.
    void approach() {
        const TubeView& view = slices_.view();
        const double least = std::atan2(slices_.part().begin, view.distance);
        const double most = std::atan2(slices_.part().end, view.distance);
        const double psi = std::clamp(psi_, -half_, half_);
        const Vec3 across = slices_.across(psi);
        double crest = std::asin(std::clamp(view.along.dot(chart_.peak()), -1.0, 1.0)), eta = 0;
        LobeChart::Place place;
        for (int step = 0; step < 2; ++step) {
            eta = std::clamp(crest, least, most);
            place = chart_.at(across * std::cos(eta) + view.along * std::sin(eta),
                              view.along * std::cos(eta) - across * std::sin(eta));
            crest = eta - place.off.dot(place.rate) / place.rate.length2();
        }
        const Vec3 light = across * std::cos(eta) + view.along * std::sin(eta);
        const Vec3 sideways = view.sideways * std::cos(psi) + view.towards * std::sin(psi);
        // Meridians crowd at the ends of the axis.
        const double crowded = std::max(std::cos(eta), 0.02);
        psi_spread_ = 1 / (chart_.at(light, sideways).rate.length() * crowded);
        if (crest < least || crest > most)
            steep_ = 2 * std::abs(place.off.dot(place.rate) * std::sin(eta) * std::cos(eta)) *
                     view.radius / view.distance;
    }

    static constexpr double picture_error = 3e-3; ///< that the coarser rule may have
    static constexpr double refinement = 1e-9;

    const TubeSlices& slices_;
    const Kernel& kernel_;
    LobeChart chart_;
    double half_;
    double psi_;            ///< wedge angle of the peak
    double psi_spread_ = 0; ///< the lobe's spread in that angle
    /// Relative change of the lobe when the lamp's end is shifted by the extent of a rim, if only
    /// the lobe's flank lies on the lamp.
    double steep_ = 0;
};

} // namespace keiko
