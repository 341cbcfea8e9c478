#include "keiko/light/luminance/clear_coat.h"

#include "keiko/light/luminance/fresnel.h"
#include "keiko/math/quadrature.h"
#include "keiko/math/refract.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {

namespace {

using std::numbers::pi;

/// Cosine below which surfaces are too nearly edge-on to have a limit.
constexpr double least_cosine = 1e-3;

const Vec3 up(0, 0, 1);

Vec3 eye_at(double cosine) {
    return {std::sqrt(std::max(0.0, 1 - cosine * cosine)), 0, cosine};
}

/// Polar coordinates about a unit vector in the plane y = 0, phi = 0 towards +x of that plane.
Vec3 about(const Vec3& pole, double theta, double phi) {
    const Vec3 across(pole.z, 0, -pole.x);
    const double sine = std::sin(theta);
    return pole * std::cos(theta) + across * (sine * std::cos(phi)) +
           Vec3(0, sine * std::sin(phi), 0);
}

/// Integral of f(theta, phi) sin(theta) over [0, end] and both halves [begin(theta), end(theta)] of
/// a function that is even in phi. Its detail near theta = 0 is as wide as `detail`.
template <class Range, class F>
Rgb polar_integral(double end, double detail, double allowed, const Range& range, const F& f) {
    const auto ring = [&](double theta) {
        const auto [from, to] = range(theta);
        if (!(from < to)) return Rgb();
        const auto arc = [&](double phi) { return f(theta, phi); };
        const double sine = std::sin(theta);
        return integrate_adaptively(arc, from, to, allowed / (10 * detail * sine), 6) * (2 * sine);
    };
    Rgb sum;
    double begin = 0;
    for (double next = std::min(detail, end); begin < end; next = std::min(2 * next, end)) {
        sum += integrate_adaptively(ring, begin, next, allowed / 4);
        begin = next;
    }
    return sum;
}

struct PhiRange {
    double from, to;
};

/// phi for which a + b cos(phi) >= 0, of [0, pi], b >= 0.
PhiRange where_positive(double a, double b) {
    if (a >= b) return {0, pi};
    if (a <= -b) return {0, 0};
    return {0, std::acos(-a / b)};
}

/// Integral of f(H, V.H) over the half vectors H of `eye` whose light has a cosine above `least`.
template <class F>
Rgb over_half_vectors(const Vec3& eye, double least, double detail, double allowed, const F& f) {
    const auto range = [&](double alpha) {
        // 2 (V.H) (N.H) - N.V >= least
        const double c = std::cos(alpha), s = std::sin(alpha);
        return where_positive(c * eye.z - (eye.z + least) / (2 * c), s * eye.x);
    };
    return polar_integral(pi / 2, detail, allowed, range, [&](double alpha, double phi) {
        const Vec3 half = about(up, alpha, phi);
        return f(half, half.dot(eye));
    });
}

} // namespace

Rgb directional_albedo(const Gloss& gloss, double cosine, double allowed, double azimuth) {
    const Vec3 eye = eye_at(std::max(cosine, least_cosine));
    const GlossKernel kernel(gloss, up, eye, Vec3(std::cos(azimuth), std::sin(azimuth), 0));
    const Distribution& facets = gloss.distribution;
    const double detail =
        facets.is_stretched() ? std::min(facets.width(), facets.across()) : kernel.spread() / 2;
    if (facets.of_half_vectors())
        return over_half_vectors(eye, 0, detail, allowed, [&](const Vec3& half, double vh) {
            const auto sent = [&](const Vec3& h) { return kernel(h * (2 * vh) - eye) * (4 * vh); };
            if (!facets.is_stretched()) return sent(half);
            return (sent(half) + sent(Vec3(half.x, -half.y, half.z))) / 2; // scratches are not even
        });
    // About the mirror direction, phi counted from the zenith's side.
    const Vec3 pole = kernel.peak();
    const auto range = [&](double theta) {
        return where_positive(std::cos(theta) * pole.z, std::sin(theta) * -pole.x);
    };
    return polar_integral(pi / 2, detail, allowed, range, [&](double theta, double phi) {
        return kernel(about(pole, theta, phi));
    });
}

Rgb directional_albedo(const Flakes& flakes, double cosine, double allowed) {
    const Vec3 eye = eye_at(std::max(cosine, least_cosine));
    const FlakeKernel kernel(flakes, up, eye);
    const double n = flakes.refractive_index;
    const Vec3 inner_eye = -*refract(-eye, up, 1 / n);
    const double critical = std::sqrt(1 - 1 / (n * n)), detail = flakes.distribution.spread() / 2;
    return over_half_vectors(inner_eye, critical, detail, allowed,
                             [&](const Vec3& half, double vh) {
                                 const Vec3 inner = half * (2 * vh) - inner_eye;
                                 const auto light = refract(inner, -up, n);
                                 if (!light || !(light->z > 0)) return Rgb();
                                 return kernel(*light) * (4 * vh * n * n * inner.z / light->z);
                             });
}

AlbedoTable::AlbedoTable(const std::function<Rgb(double cosine)>& albedo) {
    for (std::size_t i = 0; i <= steps; ++i) {
        const double root = static_cast<double>(i) / steps;
        values_[i] = albedo(root * root);
    }
    mean_ = 2 * integrate(
                    [this](double root) { return (*this)(root * root) * (2 * root * root * root); },
                    0, 1, 64);
}

Rgb AlbedoTable::operator()(double cosine) const {
    const double at = std::sqrt(std::clamp(cosine, 0.0, 1.0)) * steps;
    const auto i = std::min(static_cast<std::size_t>(at), steps - 1);
    const double rest = at - static_cast<double>(i);
    return values_[i] * (1 - rest) + values_[i + 1] * rest;
}

} // namespace keiko
