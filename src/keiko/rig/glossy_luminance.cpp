#include "keiko/rig/glossy_luminance.h"

#include "keiko/fog/transmittance.h"
#include "keiko/luminance/photometry.h"
#include "keiko/spotlight/point_light.h"
#include "keiko/tubes/lobe_reach.h"
#include "keiko/tubes/tube_irradiance.h"

namespace keiko {
namespace {

constexpr double least_share = 1e-4; ///< of a lobe's peak

/// Answers what one source gives.
template <class Kernel>
class GlossReceiver {
public:
    GlossReceiver(const std::optional<Medium>& medium, const Vec3& point, const Kernel& kernel,
                  const Visible& visible, GlossQuadrature quadrature)
        : medium_(medium),
          point_(point),
          kernel_(kernel),
          visible_(visible),
          quadrature_(quadrature),
          cone_(kernel.cone(least_share)) {}

    Rgb operator()(const CPlane& plane) const {
        const CPlaneFrame frame(plane);
        const LampRange range = lamps_in_cone(frame, point_, kernel_.peak(), cone_);
        const auto outline = plane.mirror == TubeLook::flat ? TubeOutline::rectangle
                             : plane.luminous_caps          ? TubeOutline::capped
                                                            : TubeOutline::lateral;
        Rgb sum;
        for (int i = range.begin; i < range.end; ++i)
            sum += from_lamp(lamp_of(frame, i, plane.luminance), outline);
        return plane.luminance * sum;
    }

    template <PointLight Light>
    Rgb operator()(const Light& light) const {
        const Vec3 towards = light.position - point_;
        const double distance = towards.length();
        if (!(distance > 0)) return {};
        const Rgb share = kernel_(towards / distance);
        if (share == Rgb()) return {};
        const Rgb lx = inverse_square_illuminance(intensity_towards(light, point_), distance, 1);
        if (lx == Rgb() || visible_.intervals({light.position, light.position}).empty()) return {};
        return share * lx * passed(light.position);
    }

    Rgb operator()(const Sun& sun) const {
        const Rgb share = kernel_(sun.towards());
        if (share == Rgb()) return {};
        const auto way = sun.way_to(point_);
        const Vec3 far = sun.seen_from(point_);
        if (!way || visible_.intervals({far, far}).empty()) return {};
        return share * sun.illuminance * passed(point_ + sun.towards() * *way);
    }

private:
    Rgb passed(const Vec3& from) const {
        return medium_ ? transmittance(*medium_, {from, point_}) : Rgb(1);
    }

    Rgb from_lamp(const TubeLamp& lamp, TubeOutline outline) const {
        if (below_horizon(lamp, point_, kernel_.normal())) return {};
        const auto view = view_of(lamp, point_, kernel_.normal());
        if (!view) return {};
        const IntervalSet seen = visible_.intervals({lamp.a, lamp.b});
        return sum_over_parts(*view, seen, [&](const VisiblePart& part) {
            const TubeSlices slices(*view, part, outline);
            const double middle = (part.begin + part.end) / 2;
            return TubeGloss(slices, kernel_).integral(quadrature_) *
                   passed(point_ - view->towards * view->distance + view->along * middle);
        });
    }

    const std::optional<Medium>& medium_;
    const Vec3& point_;
    const Kernel& kernel_;
    const Visible& visible_;
    GlossQuadrature quadrature_;
    double cone_;
};

} // namespace

template <class Kernel>
Rgb glossy_luminance_from(const LightSource& source, const std::optional<Medium>& medium,
                          const Vec3& point, const Kernel& kernel, const Visible& visible,
                          GlossQuadrature quadrature) {
    return std::visit(GlossReceiver(medium, point, kernel, visible, quadrature), source);
}

template Rgb glossy_luminance_from(const LightSource&, const std::optional<Medium>&, const Vec3&,
                                   const GlossKernel&, const Visible&, GlossQuadrature);
template Rgb glossy_luminance_from(const LightSource&, const std::optional<Medium>&, const Vec3&,
                                   const FlakeKernel&, const Visible&, GlossQuadrature);

} // namespace keiko
