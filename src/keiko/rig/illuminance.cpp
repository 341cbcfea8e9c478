#include "keiko/rig/illuminance.h"

#include "keiko/fog/transmittance.h"
#include "keiko/spotlight/beam_intensity.h"
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
             const Visible& visible, TubeModel model)
        : medium_(medium), point_(point), normal_(normal), visible_(visible), model_(model) {}

    Rgb operator()(const CPlane& plane) const {
        const CPlaneFrame frame(plane);
        const TubeModel model = plane.diffuse == TubeModel::automatic ? model_ : plane.diffuse;
        const CombIrradiance comb(frame, point_, normal_, model);
        Rgb solid_angle;
        for (int i = 0; i < frame.lamps; ++i) {
            const TubeLamp lamp = lamp_of(frame, i, plane.luminance);
            if (below_horizon(lamp, point_, normal_)) continue;
            const Segment axis{lamp.a, lamp.b};
            const IntervalSet seen = visible_.intervals(axis);
            solid_angle +=
                medium_ ? through_medium(comb, i, axis, seen) : Rgb(comb.solid_angle(i, seen));
        }
        return plane.luminance * solid_angle;
    }

    Rgb operator()(const Spotlight& light) const {
        const Rgb lx = illuminance(light, point_, normal_);
        if (lx == Rgb() || visible_.intervals({light.position, light.position}).empty()) return {};
        return medium_ ? lx * transmittance(*medium_, (light.position - point_).length()) : lx;
    }

private:
    /// The lamp in pieces, each seen through the medium along one distance.
    Rgb through_medium(const CombIrradiance& comb, int lamp, const Segment& axis,
                       const IntervalSet& seen) const {
        Rgb sum;
        for (const ParameterInterval& part : seen) {
            const double step = part.length() / pieces_in_fog;
            for (int i = 0; i < pieces_in_fog; ++i) {
                const double begin = part.begin + i * step;
                const double end = i + 1 < pieces_in_fog ? begin + step : part.end;
                const double way = (axis.at((begin + end) / 2) - point_).length();
                sum += transmittance(*medium_, way) *
                       comb.solid_angle(lamp, IntervalSet::whole(begin, end));
            }
        }
        return sum;
    }

    const std::optional<Medium>& medium_;
    const Vec3 &point_, &normal_;
    const Visible& visible_;
    TubeModel model_;
};

} // namespace

Rgb illuminance_from(const LightSource& source, const std::optional<Medium>& medium,
                     const Vec3& point, const Vec3& normal, const Visible& visible,
                     TubeModel model) {
    return std::visit(Receiver(medium, point, normal, visible, model), source);
}

std::vector<Rgb> illuminance_by_source(const LightRig& rig, const Vec3& point, const Vec3& normal,
                                       const Visible& visible, TubeModel model) {
    std::vector<Rgb> lx;
    for (const LightSource& source : rig.sources)
        lx.push_back(illuminance_from(source, rig.medium, point, normal, visible, model));
    return lx;
}

Rgb direct_illuminance(const LightRig& rig, const Vec3& point, const Vec3& normal,
                       const Visible& visible, TubeModel model) {
    Rgb sum;
    for (const LightSource& source : rig.sources)
        sum += illuminance_from(source, rig.medium, point, normal, visible, model);
    return sum;
}

} // namespace keiko
