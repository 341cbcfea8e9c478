#include "keiko/light/fog/single_scattering.h"

#include "keiko/light/fog/refined_integral.h"
#include "keiko/light/fog/transmittance.h"
#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace keiko {

namespace {

using Complex = std::complex<double>;

/// E1 by its power series, for |z| up to about 4.
Complex e1_series(const Complex& z) {
    Complex sum = 0, term = 1;
    for (int k = 1; k < 60; ++k) {
        term *= -z / static_cast<double>(k);
        sum -= term / static_cast<double>(k);
        if (std::abs(term) < 1e-18 * std::abs(sum)) break;
    }
    return -std::numbers::egamma - std::log(z) + sum;
}

/// exp(z) E1(z) by its continued fraction (Lentz), for larger z with a real part that is not
/// negative.
Complex scaled_e1_fraction(const Complex& z) {
    Complex b = z + 1.0, c = 1e300, d = 1.0 / b, h = d;
    for (int i = 1; i < 400; ++i) {
        const double a = -static_cast<double>(i) * i;
        b += 2.0;
        d = 1.0 / (a * d + b);
        c = b + a / c;
        const Complex step = c * d;
        h *= step;
        if (std::abs(step - 1.0) < 1e-16) break;
    }
    return h;
}

/// e^(-iu) E1(u (y - i)).
Complex turned_e1(double u, double y) {
    const Complex z(u * y, -u);
    if (std::abs(z) < 4) return std::polar(1.0, -u) * e1_series(z);
    // e^(-iu) e^(-z) = e^(-uy).
    return std::exp(-u * y) * scaled_e1_fraction(z);
}

} // namespace

double airlight(double u, double begin, double end) {
    const auto direct = [&](double xi) { return std::exp(-u * std::tan(xi)); };
    // Where attenuation is negligible, or the range is narrow, terms of the closed form cancel, and
    // the integrand is almost a polynomial.
    constexpr double quarter_turn = std::numbers::pi / 2, narrow = 0.05;
    const double width = end - begin;
    const bool smooth = quarter_turn - end > 3 * width && u * (std::tan(end) - std::tan(begin)) < 1;
    if (width < narrow && smooth) return integrate(direct, begin, end, 12);
    if (!(u > 0)) return width;
    const double last = end < quarter_turn ? std::tan(end) : HUGE_VAL;
    const Complex at_end = u * last < 700 ? turned_e1(u, last) : 0;
    return (turned_e1(u, std::tan(begin)) - at_end).imag();
}

namespace {

/// mm; see scattered_light.
constexpr double lamp_radius = 5;
constexpr int simpson_steps = 16;

/// The ray in the angle nu at the emitter: s = foot + h tan(nu), ds / r^2 = dnu / h.
class EquiAngular {
public:
    EquiAngular(const AttenuatedRay& camera_ray, const PointEmitter& emitter)
        : medium_(camera_ray.medium()),
          emitter_(emitter),
          origin_(camera_ray.ray().a),
          length_((camera_ray.ray().b - origin_).length()),
          direction_((camera_ray.ray().b - origin_) / length_),
          dimmed_(camera_ray) {
        foot_ = direction_.dot(emitter.position - origin_);
        const Vec3 nearest = origin_ + direction_ * foot_;
        distance_ = std::max((nearest - emitter.position).length(), lamp_radius);
    }

    double angle(double t) const { return std::atan2(t * length_ - foot_, distance_); }

    /// Scattered luminance per angle, cd/m2 per rad.
    Rgb operator()(double nu) const {
        const double tangent = std::tan(nu), secant = std::sqrt(1 + tangent * tangent);
        const double s = foot_ + distance_ * tangent;
        const Vec3 point = origin_ + direction_ * s;
        const Rgb cd = emitter_.intensity(point);
        if (cd == Rgb()) return {};
        const Rgb scattering = extinction_at(medium_, point) * medium_.albedo;
        Rgb depth = dimmed_.depth_to(s / length_);
        if (medium_.dims_light_leg) depth += light_leg(point, distance_ * secant);
        return scattering * cd * transmittance(depth) *
               (phase(medium_.phase, -tangent / secant) / metres(distance_));
    }

    /// Scattered luminance per parameter of the ray.
    Rgb per_parameter(double t) const {
        const double along = t * length_ - foot_;
        return (*this)(angle(t)) * (distance_ * length_ / (distance_ * distance_ + along * along));
    }

    /// Integral in closed form, for an isotropic emitter in a uniform medium that scatters
    /// isotropically (docs/theory/fog.md#the-integral).
    Rgb closed_form(const ParameterInterval& part) const {
        constexpr double pi = std::numbers::pi;
        const double begin = pi / 4 + angle(part.begin) / 2, end = pi / 4 + angle(part.end) / 2;
        const auto channel = [&](double extinction, double scattered) {
            // A light this far behind the camera contributes nothing.
            if (-extinction * metres(foot_) > 600) return 0.0;
            return scattered * std::exp(-extinction * metres(foot_)) *
                   airlight(extinction * metres(distance_), begin, end) /
                   (2 * pi * metres(distance_));
        };
        const Rgb& extinction = medium_.extinction;
        const Rgb scattered = extinction * medium_.albedo * *emitter_.even;
        return {channel(extinction.r, scattered.r), channel(extinction.g, scattered.g),
                channel(extinction.b, scattered.b)};
    }

    std::vector<double> pieces(const ParameterInterval& part) const {
        std::vector<double> breaks = dimmed_.breaks();
        breaks.insert(breaks.end(), emitter_.kinks.begin(), emitter_.kinks.end());
        return smooth_pieces(part, breaks);
    }

private:
    Rgb light_leg(const Vec3& point, double distance) const {
        if (std::holds_alternative<HomogeneousDensity>(medium_.density))
            return medium_.extinction * metres(distance);
        return optical_depth(medium_, {emitter_.position, point});
    }

    const Medium& medium_;
    const PointEmitter& emitter_;
    Vec3 origin_;
    double length_;
    Vec3 direction_;
    const AttenuatedRay& dimmed_;
    double foot_ = 0, distance_ = 0; ///< mm: distances of the emitter along and from the ray
};

bool has_closed_form(const Medium& medium, const PointEmitter& emitter) {
    const auto* haze = std::get_if<HazePhase>(&medium.phase);
    return emitter.even && haze && haze->k == 0 && medium.dims_light_leg &&
           std::holds_alternative<HomogeneousDensity>(medium.density);
}

Rgb simpson(const EquiAngular& f, const ParameterInterval& part) {
    const double step = part.length() / simpson_steps;
    Rgb sum = f.per_parameter(part.begin) + f.per_parameter(part.end);
    for (int i = 1; i < simpson_steps; ++i)
        sum += f.per_parameter(part.begin + i * step) * (i % 2 == 1 ? 4 : 2);
    return sum * (step / 3);
}

Rgb gauss(const EquiAngular& f, const ParameterInterval& part, double tolerance) {
    std::vector<double> ends = f.pieces(part);
    for (double& end : ends) end = f.angle(end);
    return RefinedIntegral(f, tolerance)(ends);
}

} // namespace

Rgb scattered_light(const AttenuatedRay& camera_ray, const IntervalSet& lit,
                    const PointEmitter& emitter, double tolerance) {
    const Medium& medium = camera_ray.medium();
    if (!(camera_ray.ray().b != camera_ray.ray().a) || lit.empty()) return {};
    const EquiAngular f(camera_ray, emitter);
    const bool closed = has_closed_form(medium, emitter);
    Rgb sum;
    for (const ParameterInterval& part : lit)
        sum += medium.rule == ScatteringRule::simpson ? simpson(f, part)
               : closed                               ? f.closed_form(part)
                                                      : gauss(f, part, tolerance);
    return sum;
}

} // namespace keiko
