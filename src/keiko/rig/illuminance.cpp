#include "keiko/rig/illuminance.h"

#include "keiko/fog/transmittance.h"
#include "keiko/spotlight/beam_intensity.h"
#include "keiko/tubes/coat_entry.h"
#include "keiko/tubes/comb_irradiance.h"
#include "keiko/tubes/tube_irradiance.h"

namespace keiko {
namespace {

/// Pieces of a visible part of a lamp that are attenuated by one distance each.
constexpr int pieces_in_fog = 8;

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
        Rgb solid_angle;
        for (int i = 0; i < frame.lamps; ++i) {
            const TubeLamp lamp = lamp_of(frame, i, plane.luminance);
            if (below_horizon(lamp, point_, normal_)) continue;
            const IntervalSet seen = visible_.intervals({lamp.a, lamp.b});
            solid_angle +=
                medium_ || coat_ ? in_pieces(comb, i, lamp, seen) : Rgb(comb.solid_angle(i, seen));
        }
        return plane.luminance * solid_angle;
    }

    Rgb operator()(const Spotlight& light) const {
        const Rgb lx = illuminance(light, point_, normal_);
        if (lx == Rgb() || visible_.intervals({light.position, light.position}).empty()) return {};
        const Vec3 towards = light.position - point_;
        const double distance = towards.length();
        return lx * passed(distance) *
               (coat_ ? coat_->entering(normal_.dot(towards) / distance) : 1);
    }

private:
    Rgb passed(double distance) const {
        return medium_ ? transmittance(*medium_, distance) : Rgb(1);
    }

    /// The lamp in pieces, each seen through the medium along one distance, and what of each enters
    /// the coat.
    Rgb in_pieces(const CombIrradiance& comb, int index, const TubeLamp& lamp,
                  const IntervalSet& seen) const {
        const auto view = coat_ ? view_of(lamp, point_, normal_) : std::nullopt;
        const int pieces = medium_ ? pieces_in_fog : 1;
        Rgb sum;
        for (const ParameterInterval& part : seen) {
            const double step = part.length() / pieces;
            for (int i = 0; i < pieces; ++i) {
                const double begin = part.begin + i * step;
                const double end = i + 1 < pieces ? begin + step : part.end;
                const double omega = comb.solid_angle(index, IntervalSet::whole(begin, end));
                const Vec3 middle = lamp.a + (lamp.b - lamp.a) * ((begin + end) / 2);
                sum += passed((middle - point_).length()) * (omega * entering(view, {begin, end}));
            }
        }
        return sum;
    }

    /// A lamp seen from the line of its axis shows its cap alone.
    double entering(const std::optional<TubeView>& view, const ParameterInterval& piece) const {
        if (!view) return 1;
        return entering_share(*coat_, *view, {view->x_at(piece.begin), view->x_at(piece.end)});
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
