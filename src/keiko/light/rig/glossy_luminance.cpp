#include "keiko/light/areas/area_gloss.h"
#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/areas/contour_width.h"
#include "keiko/light/areas/ellipse_width.h"
#include "keiko/light/areas/frustum_width.h"
#include "keiko/light/fog/transmittance.h"
#include "keiko/light/luminance/gloss_slice.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/light/rig/surface_light.h"
#include "keiko/light/sky/sky_gloss.h"
#include "keiko/light/spotlight/point_light.h"
#include "keiko/light/tubes/tube_hit.h"
#include "keiko/light/tubes/tube_irradiance.h"

namespace keiko {
namespace {

constexpr double least_share = 1e-4; ///< of a lobe's peak
/// Relative errors of what a lobe reflects of a panel or a sphere.
constexpr double picture_error = 3e-3, number_error = 1e-6;

/// Luminance of some lamps of a source.
template <class Kernel>
class GlossReceiver {
public:
    GlossReceiver(std::span<const int> asked, std::span<const LightVisibility> seen,
                  const std::optional<Medium>& medium, const Vec3& point, const Kernel& kernel,
                  const Visibility& visible, GlossQuadrature quadrature)
        : asked_(asked),
          seen_(seen),
          medium_(medium),
          point_(point),
          kernel_(kernel),
          visible_(visible),
          quadrature_(quadrature),
          cone_(kernel.cone(least_share)) {}

    std::vector<Rgb> operator()(const LampRow& row) const {
        const CPlane& plane = row.plane;
        const LampRange range = lamps_in_cone(row.frame, point_, kernel_.peak(), cone_);
        const auto outline = plane.mirror == MirrorModel::flat ? TubeOutline::rectangle
                             : plane.luminous_caps             ? TubeOutline::capped
                                                               : TubeOutline::lateral;
        std::vector<Rgb> sent(asked_.size());
        for (std::size_t k = 0; k < asked_.size(); ++k)
            if (asked_[k] >= range.begin && asked_[k] < range.end)
                sent[k] =
                    plane.luminance * from_lamp(lamp_of(row.frame, asked_[k], plane.luminance),
                                                seen_[k].axis, outline);
        return sent;
    }

    std::vector<Rgb> operator()(const SkyLight& sky) const {
        std::vector<Rgb> sent(asked_.size());
        for (std::size_t i = 0; i < asked_.size(); ++i)
            if (seen_[i].share > 0)
                if (const auto panel = sky_panel(sky, asked_[i], point_))
                    sent[i] = from_panel(sky, *panel) * seen_[i].share;
        return sent;
    }

    template <class Light>
    std::vector<Rgb> operator()(const Light& light) const {
        return {from(light)};
    }

private:
    template <PointLight Light>
    Rgb from(const Light& light) const {
        const Vec3 towards = light.position - point_;
        const double distance = towards.length();
        if (!(distance > 0)) return {};
        const Rgb share = kernel_(towards / distance);
        if (share == Rgb()) return {};
        const Rgb lx = inverse_square_illuminance(intensity_towards(light, point_), distance, 1);
        if (lx == Rgb() || seen_[0].axis.empty()) return {};
        return share * lx * passed(light.position);
    }

    Rgb from(const Sun& sun) const {
        const Rgb share = kernel_(sun.towards());
        if (share == Rgb()) return {};
        const auto way = sun.way_to(point_);
        if (!way || seen_[0].axis.empty()) return {};
        return share * sun.illuminance * passed(point_ + sun.towards() * *way);
    }

    /// The lobe over the whole source, times its visible share.
    template <AreaLight Light>
    Rgb from(const Light& light) const {
        const double seen = seen_[0].share;
        if (!(seen > 0) || least_angle(light, point_, kernel_.peak()) > cone_) return {};
        const auto width = width_of(light, point_, kernel_.normal());
        if (!width) return {};
        const AreaGloss gloss(*width, kernel_, error());
        const Rgb sent = medium_ ? gloss.integral([&](const Vec3& place) { return passed(place); })
                                 : gloss.integral();
        if (sent == Rgb()) return {};
        return light.luminance * sent * (seen < 1 ? share_of(*width, gloss) : 1);
    }

    template <class Width>
    double share_of(const Width& width, const AreaGloss<Width, Kernel>& gloss) const {
        const WidthOptions accuracy = area_accuracy(in_picture());
        if constexpr (std::same_as<Width, ContourWidth>)
            return visible_gloss_share(gloss, VisibleFront(width, visible_), accuracy);
        else
            return visible_gloss_share(gloss, visible_, accuracy);
    }

    /// The intensity is that across the line times cos(eta), and dl / r^2 = d(eta) / distance.
    Rgb from(const LineLight& light) const {
        const auto view = view_of(light, point_);
        if (!view || seen_[0].axis.empty()) return {};
        const GlossSlice slice(view->along, view->across, kernel_, kernel_.chart());
        const auto arrives = [&](double eta) { return passed(view->place(eta)); };
        Rgb sum;
        for (const ParameterInterval& part : seen_[0].axis)
            sum += slice.paired(view->above_horizon(part, kernel_.normal()), error(), arrives);
        return light.intensity * sum * per_metre(1 / view->distance);
    }

    /// The lobe over the whole of a panel of the sky.
    Rgb from_panel(const SkyLight& sky, const SkyPanel& panel) const {
        const auto width = SkyWidth::of(sky, panel, point_, kernel_.normal());
        if (!width) return {};
        const SkyKernel kernel(kernel_, *width);
        const AreaGloss gloss(*width, kernel, error());
        const Rgb sent = medium_ ? gloss.integral([&](const Vec3& place) { return passed(place); })
                                 : gloss.integral();
        return (panel.ground ? sky.ground : sky.luminance) * sent;
    }

    bool in_picture() const { return quadrature_ == GlossQuadrature::picture; }
    double error() const { return in_picture() ? picture_error : number_error; }
    Rgb passed(const Vec3& from) const {
        return medium_ ? transmittance(*medium_, {from, point_}) : Rgb(1);
    }

    Rgb from_lamp(const TubeLamp& lamp, const IntervalSet& seen, TubeOutline outline) const {
        if (below_horizon(lamp, point_, kernel_.normal())) return {};
        const auto view = view_of(lamp, point_, kernel_.normal());
        if (!view) return {};
        return sum_over_parts(*view, seen, [&](const VisiblePart& part) {
            const TubeSlices slices(*view, part, outline);
            const double middle = (part.begin + part.end) / 2;
            return TubeGloss(slices, kernel_).integral(quadrature_) *
                   passed(point_ - view->towards * view->distance + view->along * middle);
        });
    }

    std::span<const int> asked_; ///< numbers of lamps
    std::span<const LightVisibility> seen_;
    const std::optional<Medium>& medium_;
    const Vec3& point_;
    const Kernel& kernel_;
    const Visibility& visible_;
    GlossQuadrature quadrature_;
    double cone_;
};

} // namespace

template <class Kernel>
Rgb glossy_luminance_from(const PreparedSource& source, const std::optional<Medium>& medium,
                          const Vec3& point, const Kernel& kernel, const Visibility& visible,
                          GlossQuadrature quadrature) {
    const std::vector<int> lamps = source.lamp_numbers();
    const std::vector<LightVisibility> seen =
        light_visibilities(source, lamps, point, kernel.normal(), visible, TubeModel::preview);
    Rgb sum;
    for (const Rgb& sent :
         glossy_luminance_by_lamp(source, lamps, seen, medium, point, kernel, visible, quadrature))
        sum += sent;
    return sum;
}

template <class Kernel>
std::vector<Rgb> glossy_luminance_by_lamp(const PreparedSource& source, std::span<const int> lamps,
                                          std::span<const LightVisibility> seen,
                                          const std::optional<Medium>& medium, const Vec3& point,
                                          const Kernel& kernel, const Visibility& visible,
                                          GlossQuadrature quadrature) {
    return std::visit(GlossReceiver(lamps, seen, medium, point, kernel, visible, quadrature),
                      source.kind());
}

template Rgb glossy_luminance_from(const PreparedSource&, const std::optional<Medium>&, const Vec3&,
                                   const GlossKernel&, const Visibility&, GlossQuadrature);
template Rgb glossy_luminance_from(const PreparedSource&, const std::optional<Medium>&, const Vec3&,
                                   const FlakeKernel&, const Visibility&, GlossQuadrature);

template std::vector<Rgb> glossy_luminance_by_lamp(const PreparedSource&, std::span<const int>,
                                                   std::span<const LightVisibility>,
                                                   const std::optional<Medium>&, const Vec3&,
                                                   const GlossKernel&, const Visibility&,
                                                   GlossQuadrature);
template std::vector<Rgb> glossy_luminance_by_lamp(const PreparedSource&, std::span<const int>,
                                                   std::span<const LightVisibility>,
                                                   const std::optional<Medium>&, const Vec3&,
                                                   const FlakeKernel&, const Visibility&,
                                                   GlossQuadrature);

} // namespace keiko
