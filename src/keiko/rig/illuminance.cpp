#include "keiko/rig/illuminance.h"

#include "keiko/fog/transmittance.h"
#include "keiko/spotlight/point_light.h"
#include "keiko/tubes/coat_entry.h"
#include "keiko/tubes/comb_irradiance.h"
#include "keiko/tubes/tube_irradiance.h"
#include "keiko/tubes/tube_penumbra.h"

#include <numbers>
#include <span>
#include <vector>

namespace keiko {
namespace {

/// Pieces of a visible part of a lamp that are attenuated by one distance each.
constexpr int pieces_in_fog = 8;
constexpr double pi = std::numbers::pi;
/// Of a lamp's illuminance: what its penumbrae may be off by, half of what the whole system may.
constexpr double width_tolerance = 5e-5, width_tolerance_in_pictures = 3e-3;

/// Answers what one source gives to the point.
class Receiver {
public:
    Receiver(const std::optional<Medium>& medium, const Vec3& point, const Vec3& normal,
             const Visible& visible, TubeModel model, const ClearCoat* coat)
        : medium_(medium),
          point_(point),
          normal_(normal),
          visible_(visible),
          model_(model),
          coat_(coat) {}

    Rgb operator()(const CPlane& plane) const {
        const CPlaneFrame frame(plane);
        const TubeModel model = plane.diffuse == TubeModel::automatic ? model_ : plane.diffuse;
        const CombIrradiance comb(frame, point_, normal_, model);
        std::vector<int> above;
        std::vector<TubeLamp> lamps;
        for (int i = 0; i < frame.lamps; ++i) {
            const TubeLamp lamp = lamp_of(frame, i, plane.luminance);
            if (below_horizon(lamp, point_, normal_)) continue;
            above.push_back(i);
            lamps.push_back(lamp);
        }
        return plane.luminance * (asks_for_width(model) ? over_width(comb, above, lamps)
                                                        : over_axes(comb, above, lamps));
    }

    template <PointLight Light>
    Rgb operator()(const Light& light) const {
        const Rgb lx = illuminance(light, point_, normal_);
        if (lx == Rgb() || visible_.intervals({light.position, light.position}).empty()) return {};
        const Vec3 towards = light.position - point_;
        return lx * passed(light.position) *
               (coat_ ? coat_->entering(normal_.dot(towards) / towards.length()) : 1);
    }

    Rgb operator()(const Sun& sun) const {
        const double cosine = normal_.dot(sun.towards());
        if (!(cosine > 0)) return {};
        const auto way = sun.way_to(point_);
        const Vec3 far = sun.seen_from(point_);
        if (!way || visible_.intervals({far, far}).empty()) return {};
        return sun.illuminance * passed(point_ + sun.towards() * *way) *
               (cosine * (coat_ ? coat_->entering(cosine) : 1));
    }

private:
    /// Whether shadows are weighed over the whole width of the lamps: by the models that stand for
    /// the whole tube.
    bool asks_for_width(TubeModel model) const {
        const bool wide = model_ == TubeModel::automatic || model_ == TubeModel::picture;
        return wide &&
               (model == model_ || model == TubeModel::strip || model == TubeModel::cylinder);
    }
    /// Solid angles of what is seen of some lamps' axes, as `lit_over` has it.
    Rgb over_axes(const CombIrradiance& comb, std::span<const int> numbers,
                  std::span<const TubeLamp> lamps) const {
        Rgb sum;
        for (std::size_t k = 0; k < lamps.size(); ++k)
            sum +=
                lit_over(comb, numbers[k], lamps[k], visible_.intervals({lamps[k].a, lamps[k].b}));
        return sum;
    }
    Rgb over_width(const CombIrradiance& comb, std::span<const int> numbers,
                   std::span<const TubeLamp> lamps) const {
        const bool number = model_ == TubeModel::automatic;
        std::vector<std::vector<HidingTube>> hiding;
        if (comb.overlapping())
            for (const int lamp : numbers) hiding.push_back(comb.hiding_tubes(lamp));
        const std::vector<double> shares = visible_shares(
            lamps, point_, normal_, visible_,
            number ? width_tolerance : width_tolerance_in_pictures, TubeShape::cylinder, hiding);
        Rgb sum;
        for (std::size_t k = 0; k < lamps.size(); ++k)
            if (shares[k] > 0 || lamps[k].luminous_caps)
                sum += lit_over_width(comb, numbers[k], lamps[k], shares[k]);
        return sum;
    }
    /// Of the whole lamp, the share that is seen over the width. What a coat and the medium leave
    /// of it they leave of what is seen of the axis, or, where that lights nothing, of all of it.
    Rgb lit_over_width(const CombIrradiance& comb, int index, const TubeLamp& lamp,
                       double seen) const {
        const double all = seen_solid_angle(comb, index, lamp, seen);
        if (!coat_ && !medium_) return Rgb(all);
        IntervalSet parts = visible_.intervals({lamp.a, lamp.b});
        if (!(comb.solid_angle(index, parts) > 0)) parts = IntervalSet::whole();
        const double lit = comb.solid_angle(index, parts);
        return lit > 0 ? lit_over(comb, index, lamp, parts) * (all / lit) : Rgb();
    }
    double seen_solid_angle(const CombIrradiance& comb, int index, const TubeLamp& lamp,
                            double seen) const {
        const double whole = comb.solid_angle(index, IntervalSet::whole());
        if (!lamp.luminous_caps) return whole * seen;
        // A shining cap is seen where its end of the axis is.
        const IntervalSet axis = visible_.intervals({lamp.a, lamp.b});
        return (whole - cap_solid_angle(lamp, point_, normal_)) * seen +
               cap_solid_angle(lamp, point_, normal_, axis);
    }
    /// Solid angle of parts of a lamp, dimmed by the medium; with a coat, of what enters it.
    Rgb lit_over(const CombIrradiance& comb, int index, const TubeLamp& lamp,
                 const IntervalSet& parts) const {
        return medium_ ? through_medium(comb, index, lamp, parts)
                       : Rgb(entered(comb, index, lamp, parts));
    }
    Rgb passed(const Vec3& from) const {
        return medium_ ? transmittance(*medium_, {from, point_}) : Rgb(1);
    }

    /// The lamp in pieces, each seen through the medium along one distance: to the mean of the
    /// tube's near side, weighed as it is seen.
    Rgb through_medium(const CombIrradiance& comb, int index, const TubeLamp& lamp,
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

    /// Solid angle of the visible parts of a lamp; with a coat, of what enters it.
    double entered(const CombIrradiance& comb, int index, const TubeLamp& lamp,
                   const IntervalSet& seen) const {
        if (!coat_) return comb.solid_angle(index, seen);
        const auto view = view_of(lamp, point_, normal_);
        if (!view) return comb.solid_angle(index, seen); // a cap alone, seen along the axis
        const auto share = [&](const ParameterInterval& part) {
            return entering_share(*coat_, *view, {view->x_at(part.begin), view->x_at(part.end)});
        };
        if (seen.size() == 1) return comb.solid_angle(index, seen) * share(seen[0]);
        double sum = 0;
        for (const ParameterInterval& part : seen)
            sum += comb.solid_angle(index, IntervalSet({part})) * share(part);
        return sum;
    }

    const std::optional<Medium>& medium_;
    const Vec3 &point_, &normal_;
    const Visible& visible_;
    TubeModel model_;
    const ClearCoat* coat_; ///< may be null
};

} // namespace

Rgb illuminance_from(const LightSource& source, const std::optional<Medium>& medium,
                     const Vec3& point, const Vec3& normal, const Visible& visible, TubeModel model,
                     const ClearCoat* coat) {
    return std::visit(Receiver(medium, point, normal, visible, model, coat), source);
}

std::vector<Rgb> illuminance_by_source(const LightRig& rig, const Vec3& point, const Vec3& normal,
                                       const Visible& visible, TubeModel model) {
    std::vector<Rgb> lx;
    for (const LightSource& source : rig.sources)
        lx.push_back(illuminance_from(source, rig.medium, point, normal, visible, model));
    return lx;
}

Rgb direct_illuminance(const LightRig& rig, const Vec3& point, const Vec3& normal,
                       const Visible& visible, TubeModel model, const ClearCoat* coat) {
    Rgb sum;
    for (const LightSource& source : rig.sources)
        sum += illuminance_from(source, rig.medium, point, normal, visible, model, coat);
    return sum;
}

} // namespace keiko
