#pragma once

#include "keiko/light/areas/area_width.h"
#include "keiko/light/luminance/gloss_slice.h"
#include "keiko/light/penumbra/width_share.h"
#include "keiko/math/quadrature.h"
#include "keiko/math/rgb.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <vector>

namespace keiko {

/// Integral of a kernel (GlossKernel, FlakeKernel, SkyKernel) over the directions to a source above
/// the horizon, in lines of the source: an AreaWidth, or a SkyWidth. Times the source's luminance
/// it is the luminance that the surface reflects to the viewer (docs/theory/areas.md#lobes).
template <class Width, class Kernel>
class AreaGloss final : public SourceWidth {
public:
    /// Prepares the integral: measures the lobe at the source's nearest place to the peak. Pairs of
    /// rules agree within `relative` of the whole. References to both are kept.
    AreaGloss(const Width& width, const Kernel& kernel, double relative)
        : width_(width),
          kernel_(kernel),
          chart_(kernel.chart()),
          relative_(relative),
          cone_(kernel.cone(omitted * relative)) {
        approach();
    }

    /// The whole integral, times what `passed(place)` of the light of a place arrives.
    template <class Passed>
    Rgb integral(const Passed& passed) const {
        return over_width([&](const SubAxis& axis) {
            return [&](double eta) { return passed(width_.place(axis, std::tan(eta / 2))); };
        });
    }
    /// The whole integral through a vacuum.
    Rgb integral() const {
        return over_width([](const SubAxis&) { return all_of_it; });
    }

    SubAxis sub_axis(double place) const override { return width_.sub_axis(place); }
    Segment line_of(const SubAxis& axis) const override { return width_.line_of(axis); }
    /// Luminance of the kernel's integral over a part of a line, by the wedge angle.
    double lit(const SubAxis& axis, double begin, double end) const override {
        return luminance(in_half_plane(axis, width_.elevations(axis, begin, end), all_of_it));
    }
    /// Cuts of the source, and some about the lobe's peak.
    std::vector<double> cuts() const override {
        std::vector<double> cuts;
        const std::vector<double> own = width_.cuts();
        for (std::size_t i = 0; i + 1 < own.size(); ++i)
            for (const double place : about_peak(own[i], own[i + 1]).places())
                if (cuts.empty() || place > cuts.back()) cuts.push_back(place);
        return cuts;
    }
    double place_in(const Vec3& way) const override { return width_.place_in(way); }
    Prism around() const override { return width_.around(); }

private:
    static constexpr double omitted = 0.01; ///< of the error: share of the peak that is nothing

    static Rgb all_of_it(double /*eta*/) { return Rgb(1); }

    template <class PassedOn>
    Rgb over_width(const PassedOn& passed_on) const {
        const auto sent = [&](double place) {
            const SubAxis axis = width_.sub_axis(place);
            return in_half_plane(axis, width_.elevations(axis), passed_on(axis)) * axis.weight;
        };
        Rgb sum;
        const std::vector<double> cuts = width_.cuts();
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i)
            sum += integrate_paired(sent, about_peak(cuts[i], cuts[i + 1]), relative_);
        return sum;
    }
    template <class Passed>
    Rgb in_half_plane(const SubAxis& axis, const std::vector<ParameterInterval>& elevations,
                      const Passed& passed) const {
        const Vec3 level = width_.direction(axis, 0);
        const auto lobe = elevations_in_cone(level);
        if (!lobe) return {};
        const GlossSlice slice(width_.along(), level, kernel_, chart_);
        Rgb sum;
        for (const ParameterInterval& part : elevations)
            sum += slice.paired({std::max(2 * std::atan(part.begin), lobe->begin),
                                 std::min(2 * std::atan(part.end), lobe->end)},
                                relative_, passed);
        return sum;
    }
    /// Range of elevations that contains those of the cone in the half-plane through `level`;
    /// nullopt if the cone does not reach it.
    std::optional<ParameterInterval> elevations_in_cone(const Vec3& level) const {
        constexpr double quarter = std::numbers::pi / 2;
        if (!(cone_ < quarter)) return ParameterInterval{-quarter, quarter};
        const Vec3 &along = width_.along(), &peak = kernel_.peak();
        if (std::abs(level.cross(along).dot(peak)) > std::sin(cone_)) return std::nullopt;
        const double eta = std::atan2(along.dot(peak), level.dot(peak));
        return ParameterInterval{eta - cone_, eta + cone_};
    }
    Breakpoints about_peak(double begin, double end) const {
        return keiko::about_peak(begin, end, peak_, spread_);
    }
    void approach() {
        peak_ = width_.place_in(chart_.peak());
        constexpr double flank = 0.9; // of the width: at its end a sphere's rate is 0
        const SubAxis axis = width_.sub_axis(std::clamp(peak_, -flank, flank));
        const double weight = std::max(axis.weight, weight_beside(peak_));
        const Vec3 level = width_.direction(axis, 0), &along = width_.along();
        const double eta = std::atan2(along.dot(chart_.peak()), level.dot(chart_.peak()));
        const double cosine = std::cos(eta);
        const Vec3 light = level * cosine + along * std::sin(eta);
        const Vec3 sideways = level.cross(along); // the way that rising wedge angles turn, or back
        constexpr double crowded = 0.02;          // meridians crowd at the ends of the lines
        spread_ = 1 / (chart_.at(light, sideways).rate.length() *
                       std::max(std::abs(cosine), crowded) * weight);
    }
    /// A part of the weight beside a place, which itself may lie where a contour turns.
    double weight_beside(double place) const {
        constexpr double beside = 0.05, part = 0.1;
        const auto weight_at = [&](double at) {
            return width_.sub_axis(std::clamp(at, -1 + beside, 1 - beside)).weight;
        };
        return part * std::max(weight_at(place - beside), weight_at(place + beside));
    }

    const Width& width_;
    const Kernel& kernel_;
    LobeChart chart_;
    double relative_;
    double cone_;                  ///< half angle, radians, beyond which the lobe is left out
    double peak_ = 0, spread_ = 1; ///< place of the lobe's peak, and its spread in places
};

/// Visible share, 0 to 1, of what a lobe reflects of a source, by the luminance of the kernel. The
/// tolerance of the options is one of the lobe's integral.
template <class Width, class Kernel>
double visible_gloss_share(const AreaGloss<Width, Kernel>& gloss, const Visibility& visible,
                           WidthOptions options) {
    // The rule shares the tolerance out over some eight spreads of the peak's brightness, which are
    // four times as much as the lobe.
    options.tolerance /= 4;
    options.tapers = false; // a lobe ends anywhere
    return visible_share(gloss, visible, options);
}

} // namespace keiko
