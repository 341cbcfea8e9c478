#include "keiko/light/sky/sky_scattering.h"

#include "keiko/light/fog/refined_integral.h"
#include "keiko/light/luminance/gloss_slice.h"
#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

constexpr double pi = std::numbers::pi;
/// Relative error over directions, by the difference of two rules, and the least along a ray.
constexpr double of_directions = 1e-4;
/// Spread of a phase function about straight on, radians and heights: where ranges are cut.
constexpr double of_phase = 0.2;

/// Light of the sky that is scattered along a ray, at one parameter of it.
class SkyRay {
public:
    SkyRay(const AttenuatedRay& camera_ray, const SkyLight& sky)
        : camera_ray_(camera_ray),
          medium_(camera_ray.medium()),
          sky_(sky),
          shares_(sky),
          length_((camera_ray.ray().b - camera_ray.ray().a).length()),
          ahead_((camera_ray.ray().b - camera_ray.ray().a).normalized()),
          azimuth_(std::atan2(ahead_.y, ahead_.x)) {}

    /// Scattered luminance per parameter of the ray.
    Rgb operator()(double t) const {
        const Vec3 point = camera_ray_.ray().at(t);
        const Rgb arriving = transmittance(camera_ray_.depth_to(t)) * metres(length_);
        return extinction_at(medium_, point) * medium_.albedo * arriving * mean_by_phase(point);
    }
    /// Luminance scattered along the whole ray in a uniform medium, where the mean is the same all
    /// along.
    Rgb closed_form() const {
        return (Rgb(1) - transmittance(camera_ray_.depth_to(1))) * medium_.albedo *
               mean_by_phase(camera_ray_.ray().a);
    }

private:
    /// Luminance that arrives at a point from all directions, weighted by the phase function.
    Rgb mean_by_phase(const Vec3& point) const {
        const Rgb above =
            over_heights(0, 1, [&](const Vec3& way) { return arrives(point, way) * shares_(way); });
        if (sky_.ground == Rgb(0)) return sky_.luminance * above;
        return sky_.luminance * above + sky_.ground * over_heights(-1, 0, [&](const Vec3& way) {
                                            return arrives(point, way);
                                        });
    }
    /// Integral over the directions between two heights, sines of elevations, times the phase.
    template <class F>
    Rgb over_heights(double low, double high, const F& of) const {
        const auto at_height = [&](double sine) {
            const double cosine = std::sqrt((1 - sine) * (1 + sine));
            const auto at_azimuth = [&](double azimuth) {
                const Vec3 way(cosine * std::cos(azimuth), cosine * std::sin(azimuth), sine);
                return of(way) * phase(medium_.phase, ahead_.dot(way));
            };
            return integrate_paired(at_azimuth,
                                    about_peak(azimuth_ - pi, azimuth_ + pi, azimuth_, of_phase),
                                    of_directions);
        };
        return integrate_paired(at_height, about_peak(low, high, ahead_.z, of_phase),
                                of_directions);
    }
    /// Share of the light from a direction that arrives at a point.
    Rgb arrives(const Vec3& point, const Vec3& way) const {
        if (!medium_.dims_light_leg) return Rgb(1);
        return transmittance(medium_, {point + way * sky_distance, point});
    }

    const AttenuatedRay& camera_ray_;
    const Medium& medium_;
    const SkyLight& sky_;
    SkyDistribution shares_;
    double length_; ///< mm
    Vec3 ahead_;
    double azimuth_; ///< of the ray
};

} // namespace

Rgb scattered_light(const AttenuatedRay& camera_ray, const SkyLight& sky, double tolerance) {
    if (!(camera_ray.ray().b != camera_ray.ray().a)) return {};
    const SkyRay f(camera_ray, sky);
    if (std::holds_alternative<HomogeneousDensity>(camera_ray.medium().density))
        return f.closed_form();
    return RefinedIntegral(
        f, std::max(tolerance, of_directions))(smooth_pieces({0, 1}, camera_ray.breaks()));
}

} // namespace keiko
