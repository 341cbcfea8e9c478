#include "keiko/fog/single_scattering.h"

#include "keiko/fog/transmittance.h"
#include "keiko/luminance/phase_function.h"
#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// mm; see scattered_light.
constexpr double lamp_radius = 5;

/// Of the whole, and how often a piece may be halved to get there.
constexpr double tolerance = 1e-8;
constexpr int max_depth = 12;

/// The ray in the angle nu at the emitter: s = foot + h tan(nu), ds / r^2 = dnu / h.
class EquiAngular {
public:
    EquiAngular(const Medium& medium, const Segment& ray, const PointEmitter& emitter)
        : medium_(medium),
          emitter_(emitter),
          origin_(ray.a),
          length_((ray.b - ray.a).length()),
          direction_((ray.b - ray.a) / length_) {
        foot_ = direction_.dot(emitter.position - origin_);
        const Vec3 nearest = origin_ + direction_ * foot_;
        distance_ = std::max((nearest - emitter.position).length(), lamp_radius);
    }

    double angle(double t) const { return std::atan2(t * length_ - foot_, distance_); }

    /// Scattered luminance per angle, cd/m2 per rad.
    Rgb operator()(double nu) const {
        const double s = foot_ + distance_ * std::tan(nu), r = distance_ / std::cos(nu);
        const Rgb scattering = medium_.extinction * medium_.albedo;
        const double phase = fog_phase(-std::sin(nu), medium_.phase_k);
        return scattering * emitter_.intensity(origin_ + direction_ * s) *
               transmittance(medium_, s + r) * (phase / metres(distance_));
    }

private:
    const Medium& medium_;
    const PointEmitter& emitter_;
    Vec3 origin_;
    double length_;
    Vec3 direction_;
    double foot_ = 0, distance_ = 0; ///< mm: of the emitter along and from the ray
};

/// Halves [a, b] until 8 and 16 nodes agree within `allowed`.
Rgb refined(const EquiAngular& f, double a, double b, double allowed, int depth) {
    const Rgb coarse = integrate(f, a, b, 8), fine = integrate(f, a, b, 16);
    const Rgb gap = fine - coarse;
    const double error = std::max({std::abs(gap.r), std::abs(gap.g), std::abs(gap.b)});
    if (depth == 0 || !(error > allowed)) return fine;
    const double middle = (a + b) / 2;
    return refined(f, a, middle, allowed / 2, depth - 1) +
           refined(f, middle, b, allowed / 2, depth - 1);
}

} // namespace

Rgb scattered_light(const Medium& medium, const Segment& eye_ray, const IntervalSet& lit,
                    const PointEmitter& emitter) {
    if (!(eye_ray.b != eye_ray.a)) return {};
    const EquiAngular f(medium, eye_ray, emitter);
    Rgb sum;
    for (const ParameterInterval& part : lit) {
        const double a = f.angle(part.begin), b = f.angle(part.end);
        const double scale = max_channel(integrate(f, a, b, 8));
        sum += refined(f, a, b, tolerance * scale, max_depth);
    }
    return sum;
}

} // namespace keiko
