#include "keiko/light/areas/area_integral.h"
#include "keiko/light/areas/area_irradiance.h"
#include "keiko/light/areas/contour_width.h"
#include "keiko/light/areas/ellipse_width.h"
#include "keiko/light/areas/frustum_width.h"
#include "keiko/light/fog/transmittance.h"
#include "keiko/light/luminance/photometry.h"
#include "keiko/light/rig/surface_light.h"
#include "keiko/light/sky/sky_irradiance.h"
#include "keiko/light/spotlight/point_light.h"
#include "keiko/light/tubes/tube_irradiance.h"
#include "keiko/light/tubes/tube_slices.h"
#include "keiko/math/quadrature.h"

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

namespace keiko {
namespace {

/// Number of pieces of a visible part of a lamp, each attenuated by one distance.
constexpr int pieces_in_fog = 8;
/// Relative error of a line's light that passes a coat or a medium.
constexpr double line_error = 1e-6;
constexpr double pi = std::numbers::pi;

/// Illuminance of the point by some lamps of a source.
class Receiver {
public:
    Receiver(std::span<const int> asked, std::span<const LightVisibility> seen,
             const std::optional<Medium>& medium, const Vec3& point, const Vec3& normal,
             TubeModel model, const ClearCoat* coat)
        : asked_(asked),
          seen_(seen),
          medium_(medium),
          point_(point),
          normal_(normal),
          model_(model),
          coat_(coat) {}

    std::vector<Rgb> operator()(const LampRow& row) const {
        const CPlane& plane = row.plane;
        const TubeRowIrradiance comb(row.frame, point_, normal_, row.diffuse_model(model_));
        const bool width = weighs_width(plane, model_);
        std::vector<Rgb> lx(asked_.size());
        for (std::size_t i = 0; i < asked_.size(); ++i) {
            const TubeLamp lamp = lamp_of(row.frame, asked_[i], plane.luminance);
            if (!below_horizon(lamp, point_, normal_))
                lx[i] = plane.luminance * (width ? lit_over_width(comb, asked_[i], lamp, seen_[i])
                                                 : lit_over(comb, asked_[i], lamp, seen_[i].axis));
        }
        return lx;
    }

    std::vector<Rgb> operator()(const SkyLight& sky) const {
        std::vector<Rgb> lx(asked_.size());
        for (std::size_t i = 0; i < asked_.size(); ++i)
            if (seen_[i].share > 0)
                if (const auto panel = sky_panel(sky, asked_[i], point_))
                    lx[i] = from_panel(sky, *panel) * seen_[i].share;
        return lx;
    }

    template <class Light>
    std::vector<Rgb> operator()(const Light& light) const {
        return {from(light)};
    }

private:
    template <PointLight Light>
    Rgb from(const Light& light) const {
        const Rgb lx = illuminance(light, point_, normal_);
        if (lx == Rgb() || seen_[0].axis.empty()) return {};
        const Vec3 towards = light.position - point_;
        return lx * passed(light.position) *
               (coat_ ? coat_->entering(normal_.dot(towards) / towards.length()) : 1);
    }

    Rgb from(const Sun& sun) const {
        const double cosine = normal_.dot(sun.towards());
        if (!(cosine > 0)) return {};
        const auto way = sun.way_to(point_);
        if (!way || seen_[0].axis.empty()) return {};
        return sun.illuminance * passed(point_ + sun.towards() * *way) *
               (cosine * (coat_ ? coat_->entering(cosine) : 1));
    }

    Rgb from(const LineLight& light) const {
        const auto view = view_of(light, point_);
        if (!view || seen_[0].axis.empty()) return {};
        if (!coat_ && !medium_)
            return light.intensity * unit_illuminance(*view, normal_, seen_[0].axis);
        const auto arrives = [&](double eta) {
            const Vec3 way = view->direction(eta);
            const double cosine = normal_.dot(way);
            return passed(view->place(eta)) *
                   (cosine * std::cos(eta) * (coat_ ? coat_->entering(cosine) : 1));
        };
        Rgb sum;
        for (const ParameterInterval& part : seen_[0].axis) {
            const ParameterInterval above = view->above_horizon(part, normal_);
            if (above.begin < above.end)
                sum += integrate_paired(arrives, Breakpoints(above.begin, above.end), line_error);
        }
        return light.intensity * sum * per_metre(1 / view->distance);
    }

    /// Illuminance by the whole source times its visible share. The transmittance of a coat and of
    /// the medium is that of all of it.
    template <AreaLight Light>
    Rgb from(const Light& light) const {
        if (!(seen_[0].share > 0)) return {};
        const Rgb lx = light.luminance * (whole_of(light) * seen_[0].share);
        if (!coat_ && !medium_) return lx;
        const auto width = width_of(light, point_, normal_);
        if (!width) return {};
        return lx * mean_over(*width, [&](const Vec3& place) {
                   const Vec3 way = place - point_;
                   const double cosine = normal_.dot(way) / way.length();
                   return passed(place) * (coat_ ? coat_->entering(cosine) : 1);
               });
    }

    template <AreaLight Light>
    double whole_of(const Light& light) const {
        return projected_solid_angle(light, point_, normal_);
    }
    double whole_of(const ContourLight& light) const {
        constexpr double picture_error = 1e-3, number_error = 1e-6;
        return projected_solid_angle(light, point_, normal_,
                                     model_ == TubeModel::automatic ? number_error : picture_error);
    }

    /// Illuminance by the whole of a panel of the sky, with the mean transmittance of a coat and of
    /// the medium.
    Rgb from_panel(const SkyLight& sky, const SkyPanel& panel) const {
        const Rgb lx = illuminance_from(sky, panel, point_, normal_);
        if (!coat_ && !medium_) return lx;
        const auto width = SkyWidth::of(sky, panel, point_, normal_);
        if (!width) return {};
        return lx * mean_over(*width, [&](const Vec3& place) {
                   const Vec3 way = place - point_;
                   const double cosine = normal_.dot(way) / way.length();
                   return passed(place) * (coat_ ? coat_->entering(cosine) : 1);
               });
    }

    /// Illuminance by the whole lamp times its share visible over the width. The transmittance of a
    /// coat and of the medium is that of the visible axis, or, if that lights nothing, of all of
    /// it.
    Rgb lit_over_width(const TubeRowIrradiance& comb, int index, const TubeLamp& lamp,
                       const LightVisibility& seen) const {
        if (!(seen.share > 0) && !(lamp.luminous_caps && seen.cap > 0)) return {};
        const double all = seen_solid_angle(comb, index, lamp, seen);
        if (!coat_ && !medium_) return Rgb(all);
        for (const IntervalSet& parts : {seen.axis, IntervalSet::whole()})
            if (const double lit = comb.solid_angle(index, parts); lit > 0)
                return lit_over(comb, index, lamp, parts) * (all / lit);
        return {};
    }
    double seen_solid_angle(const TubeRowIrradiance& comb, int index, const TubeLamp& lamp,
                            const LightVisibility& seen) const {
        const double whole = comb.solid_angle(index, IntervalSet::whole());
        if (!lamp.luminous_caps) return whole * seen.share;
        const double cap = cap_solid_angle(lamp, point_, normal_);
        return (whole - cap) * seen.share + cap * seen.cap;
    }
    /// Solid angle of parts of a lamp, attenuated by the medium; with a coat, only the light that
    /// enters it.
    Rgb lit_over(const TubeRowIrradiance& comb, int index, const TubeLamp& lamp,
                 const IntervalSet& parts) const {
        return medium_ ? through_medium(comb, index, lamp, parts)
                       : Rgb(entered(comb, index, lamp, parts));
    }
    Rgb passed(const Vec3& from) const {
        return medium_ ? transmittance(*medium_, {from, point_}) : Rgb(1);
    }

    /// Solid angle of the lamp in pieces, each through the medium along one distance: the mean
    /// distance of the tube's near side, weighted by its projection.
    Rgb through_medium(const TubeRowIrradiance& comb, int index, const TubeLamp& lamp,
                       const IntervalSet& seen) const {
        const auto view = view_of(lamp, point_, normal_);
        const Vec3 to_side = view ? view->towards * (view->radius * pi / 4) : Vec3(0);
        Rgb sum;
        for (const ParameterInterval& part : seen) {
            const double step = part.length() / pieces_in_fog;
            for (int i = 0; i < pieces_in_fog; ++i) {
                const double begin = part.begin + i * step;
                const double end = i + 1 < pieces_in_fog ? begin + step : part.end;
                const Vec3 middle = lamp.a + (lamp.b - lamp.a) * ((begin + end) / 2);
                sum += passed(middle + to_side) *
                       entered(comb, index, lamp, IntervalSet::whole(begin, end));
            }
        }
        return sum;
    }

    /// Solid angle of the visible parts of a lamp; with a coat, only the light that enters it.
    double entered(const TubeRowIrradiance& comb, int index, const TubeLamp& lamp,
                   const IntervalSet& seen) const {
        if (!coat_) return comb.solid_angle(index, seen);
        const auto view = view_of(lamp, point_, normal_);
        if (!view) return comb.solid_angle(index, seen); // a cap alone, viewed along the axis
        const auto outline = lamp.luminous_caps ? TubeOutline::capped : TubeOutline::lateral;
        const auto share = [&](const ParameterInterval& part) {
            const VisiblePart visible{view->x_at(part.begin), view->x_at(part.end),
                                      !(part.begin > 0), !(part.end < 1)};
            return entering_share(*coat_, TubeSlices(*view, visible, outline), model_);
        };
        if (seen.size() == 1) return comb.solid_angle(index, seen) * share(seen[0]);
        double sum = 0;
        for (const ParameterInterval& part : seen)
            sum += comb.solid_angle(index, IntervalSet({part})) * share(part);
        return sum;
    }

    std::span<const int> asked_; ///< numbers of lamps
    std::span<const LightVisibility> seen_;
    const std::optional<Medium>& medium_;
    const Vec3 &point_, &normal_;
    TubeModel model_;
    const ClearCoat* coat_; ///< may be null
};

} // namespace

Rgb illuminance_from(const PreparedSource& source, const std::optional<Medium>& medium,
                     const Vec3& point, const Vec3& normal, const Visibility& visible,
                     TubeModel model, const ClearCoat* coat) {
    const std::vector<int> lamps = source.lamp_numbers();
    const std::vector<LightVisibility> seen =
        light_visibilities(source, lamps, point, normal, visible, model, coat || medium);
    Rgb sum;
    for (const Rgb& lx :
         illuminance_by_lamp(source, lamps, seen, medium, point, normal, model, coat))
        sum += lx;
    return sum;
}

std::vector<Rgb> illuminance_by_lamp(const PreparedSource& source, std::span<const int> lamps,
                                     std::span<const LightVisibility> seen,
                                     const std::optional<Medium>& medium, const Vec3& point,
                                     const Vec3& normal, TubeModel model, const ClearCoat* coat) {
    return std::visit(Receiver(lamps, seen, medium, point, normal, model, coat), source.kind());
}

std::vector<Rgb> illuminance_by_source(const LightRig& rig, const Vec3& point, const Vec3& normal,
                                       const Visibility& visible, TubeModel model) {
    std::vector<Rgb> lx;
    for (const LightSource& source : rig.sources)
        lx.push_back(illuminance_from(source, rig.medium, point, normal, visible, model));
    return lx;
}

Rgb direct_illuminance(const LightRig& rig, const Vec3& point, const Vec3& normal,
                       const Visibility& visible, TubeModel model, const ClearCoat* coat) {
    Rgb sum;
    for (const LightSource& source : rig.sources)
        sum += illuminance_from(source, rig.medium, point, normal, visible, model, coat);
    return sum;
}

} // namespace keiko
