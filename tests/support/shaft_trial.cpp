#include "tests/support/shaft_trial.h"

#include "keiko/base/units.h"
#include "keiko/light/fog/transmittance.h"
#include "keiko/light/rig/luminance_along.h"
#include "keiko/light/spotlight/spotlight.h"
#include "keiko/render/shading/occluded_visibility.h"

#include <cmath>
#include <numbers>

namespace keiko::test {
namespace {

LightRig ring_of_lamps(const Box3& body, int lamps) {
    LightRig rig;
    rig.medium = Medium{.extinction = Rgb(0.05), .albedo = Rgb(0.9), .phase = HazePhase{8}};
    const double size = body.size();
    for (int i = 0; i < lamps; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.3) / lamps;
        const Vec3 side(std::cos(angle), std::sin(angle), 0);
        const Vec3 foot(body.center().x, body.center().y, body.lower.z);
        rig.sources.emplace_back(
            Spotlight{.position = foot + side * (0.5 * size) + Vec3(0, 0, 0.8 * size),
                      .aim = body.center(),
                      .half_angle = 18,
                      .profile = EdgeProfile{BeamEdge::sharp, 0}});
    }
    return rig;
}

/// Scattered light of one lamp at places along a ray.
class March {
public:
    March(const Medium& medium, const Tracer& tracer, const Spotlight& light, const Segment& ray)
        : medium_(medium),
          tracer_(tracer),
          intensity_(light),
          viewpoint_(Viewpoint::at(light.position)),
          origin_(ray.a),
          length_((ray.b - ray.a).length()),
          direction_((ray.b - ray.a) / length_) {
        foot_ = direction_.dot(light.position - ray.a);
        distance_ = (origin_ + direction_ * foot_ - light.position).length();
    }

    Rgb over(const ParameterInterval& part, int steps, Marching marching) {
        const double begin = part.begin * length_, end = part.end * length_;
        const bool even = marching == Marching::even;
        const double low = even ? begin : angle(begin), high = even ? end : angle(end);
        const double step = (high - low) / steps;
        places_.clear(), rays_.clear();
        for (int i = 0; i < steps; ++i) {
            const double u = low + (i + 0.5) * step;
            const double s = even ? u : foot_ + distance_ * std::tan(u);
            const double off = s - foot_, r2 = distance_ * distance_ + off * off;
            places_.push_back({s, even ? step : step * r2 / distance_});
            rays_.push_back(viewpoint_.ray_to(origin_ + direction_ * s));
        }
        const std::vector<bool> hidden = tracer_.any(rays_);
        Rgb sum;
        for (std::size_t i = 0; i < places_.size(); ++i)
            if (!hidden[i]) sum += at(places_[i].s) * metres(places_[i].width);
        return sum;
    }

private:
    struct Place {
        double s, width; ///< mm
    };

    double angle(double s) const { return std::atan2(s - foot_, distance_); }
    /// cd/m2 per metre.
    Rgb at(double s) const {
        const double along = s - foot_, r = std::hypot(distance_, along);
        const Rgb depth = medium_.extinction * metres(s + r);
        return intensity_(origin_ + direction_ * s) * medium_.extinction * medium_.albedo *
               transmittance(depth) * (phase(medium_.phase, -along / r) / (metres(r) * metres(r)));
    }

    const Medium& medium_;
    const Tracer& tracer_;
    BeamIntensity intensity_;
    Viewpoint viewpoint_;
    Vec3 origin_;
    double length_;
    Vec3 direction_;
    double foot_ = 0, distance_ = 0;
    std::vector<Place> places_;
    std::vector<Ray> rays_;
};

} // namespace

ShaftTrial::ShaftTrial(SurfaceModel model, int lamps)
    : tracer_(model), occluders_(model, tracer_), rig_(ring_of_lamps(tracer_.bounds(), lamps)) {}

Camera ShaftTrial::camera() const {
    const Box3& body = tracer_.bounds();
    const Vec3 to_eye = Vec3(-1.2, -1.6, 0.1) * body.size();
    return {.eye = body.center() + to_eye, .target = body.center(), .vertical_fov = 30};
}

std::vector<std::optional<EpipolarShadows>> ShaftTrial::pencils() const {
    return shaft_pencils(rig_, &occluders_, tracer_, camera().eye);
}

std::vector<Segment> ShaftTrial::camera_rays(const Vec2& corner, int side) const {
    const Camera camera = this->camera();
    const double left = camera.width * corner.x, top = camera.height * corner.y;
    std::vector<Segment> rays;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) {
            const Ray ray = camera.ray(left + x + 0.5, top + y + 0.5);
            const auto hit = tracer_.nearest(ray);
            const double end = hit ? hit->t : 5 * tracer_.bounds().size();
            rays.push_back({ray.origin, ray.origin + ray.direction * end});
        }
    return rays;
}

std::vector<Rgb> ShaftTrial::exact(std::span<const Segment> rays, double tolerance,
                                   std::span<const std::optional<EpipolarShadows>> pencils) const {
    const VolumetricShadows shadows(rig_, &occluders_, tracer_, rays, pencils);
    const VisibleFrom visible = shadows.visible();
    std::vector<Rgb> light;
    light.reserve(rays.size());
    for (const Segment& ray : rays)
        light.push_back(luminance_along(rig_, ray, Rgb(0), visible, tolerance));
    return light;
}

Rgb ShaftTrial::marched(const Segment& ray, int steps, Marching marching) const {
    Rgb sum;
    for (const LightSource& source : rig_.sources) {
        March march(*rig_.medium, tracer_, std::get<Spotlight>(source), ray);
        for (const ParameterInterval& part : in_light(source, ray))
            sum += march.over(part, steps, marching);
    }
    return sum;
}

} // namespace keiko::test
