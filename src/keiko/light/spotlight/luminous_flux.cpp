#include "keiko/light/spotlight/luminous_flux.h"

#include "keiko/base/units.h"
#include "keiko/light/spotlight/spotlight.h"
#include "keiko/math/quadrature.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace keiko {
namespace {

using std::numbers::pi;

constexpr int nodes = 16; ///< a cell and angle

/// Angles in radians between which an intensity is smooth.
using Breaks = std::vector<double>;

/// Adds the kinks of k: multiples of half the period, and the places where negative q cuts it off.
void add_wave(Breaks& breaks, double period, double q, double end) {
    for (int i = 0; i * period / 2 <= end; ++i) {
        const double middle = i * period / 2, half_width = period / 2 / (1 - q);
        breaks.push_back(middle);
        if (q < 0)
            for (const double side : {-half_width, half_width}) breaks.push_back(middle + side);
    }
}

Breaks between(Breaks breaks, double begin, double end) {
    std::erase_if(breaks, [&](double x) { return !(x > begin && x < end); });
    breaks.push_back(begin), breaks.push_back(end);
    std::sort(breaks.begin(), breaks.end());
    const auto same = [](double a, double b) { return b - a < 1e-12; };
    breaks.erase(std::unique(breaks.begin(), breaks.end(), same), breaks.end());
    return breaks;
}

Breaks in_radians(const std::vector<double>& degrees) {
    Breaks breaks;
    for (const double angle : degrees) breaks.push_back(degrees_to_radians(angle));
    return breaks;
}

/// Kinks of the intensity over theta and over phi.
struct Kinks {
    Breaks theta{pi / 2}, phi;

    explicit Kinks(const Spotlight& light) {
        if (const auto* table = std::get_if<TableProfile>(&light.profile)) {
            for (const double x : in_radians((*table)->vertical())) theta.push_back(x);
            for (const double x : in_radians((*table)->horizontal())) add_mirrored(x);
        }
        if (const auto* petals = std::get_if<Petals>(&light.pattern))
            add_wave(phi, 2 * pi / petals->count, petals->q, 2 * pi);
        if (const auto* dots = std::get_if<Dots>(&light.pattern)) {
            add_wave(phi, degrees_to_radians(dots->dphi), dots->q_phi, 2 * pi);
            add_wave(theta, degrees_to_radians(dots->dtheta), dots->q_theta, pi);
        }
        if (light.hue)
            for (int i = 1; i < 6; ++i) phi.push_back(i * pi / 3);
        turn_back(degrees_to_radians(light.spin));
        add_mirrored(0), add_mirrored(pi / 2);
        if (light.half_angle_across)
            add_rim(std::tan(degrees_to_radians(light.half_angle)),
                    std::tan(degrees_to_radians(*light.half_angle_across)));
    }

private:
    void add_mirrored(double x) {
        for (const double folded : {x, pi - x, pi + x, 2 * pi - x}) phi.push_back(folded);
    }

    void turn_back(double spin) {
        for (double& x : phi) x = std::fmod(x - spin, 2 * pi) + (x < spin ? 2 * pi : 0);
    }

    /// Breaks of the rim cot^2 theta = cos^2 phi / a^2 + sin^2 phi / b^2, at its crossings with a
    /// kink over theta. A slim rim is singular close by, at tan phi = +-i b / a: panels that double
    /// away from there are at most as long as their distance, and keep all digits.
    void add_rim(double a, double b) {
        const double ratio = b / a;
        for (double t = std::min(1.0, ratio); t < std::max(1.0, ratio); t *= 2)
            add_mirrored(std::atan(t));
        add_mirrored(std::atan(ratio));
        for (const double x : theta) {
            const double cotangent = 1 / std::tan(x);
            const double sine2 =
                (cotangent * cotangent - 1 / (a * a)) / (1 / (b * b) - 1 / (a * a));
            if (sine2 > 0 && sine2 < 1) add_mirrored(std::asin(std::sqrt(sine2)));
        }
    }
};

template <class F>
auto over_cells(const F& f, const Breaks& breaks) {
    auto sum = f(breaks.front()) * 0.0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
        sum += integrate(f, breaks[i], breaks[i + 1], nodes);
    return sum;
}

} // namespace

Rgb luminous_flux(const Spotlight& light) {
    Spotlight still = light;
    if (!light.half_angle_across) still.spin = 0; // turns a round beam, and changes nothing
    const BeamIntensity intensity(still);
    const Kinks kinks(still);
    const auto of_meridian = [&](double phi) {
        const double rim = intensity.rim(phi), end = 2 * std::asin(std::sqrt(rim / 2));
        const auto ring = [&](double theta) {
            const double sine = std::sin(theta), half = std::sin(theta / 2);
            const BeamDirection direction{std::min(2 * half * half, rim), sine * std::cos(phi),
                                          sine * std::sin(phi)};
            return intensity.towards(direction) * sine;
        };
        return over_cells(ring, between(kinks.theta, 0, end));
    };
    return over_cells(of_meridian, between(kinks.phi, 0, 2 * pi));
}

namespace {

/// lm of the table of a web over its angles: `area` returns the solid angle of a cell of both
/// angles, in radians.
template <class Area>
double flux_over(const IntensityTable& table, const Breaks& vertical, const Breaks& horizontal,
                 const Area& area) {
    const auto of_plane = [&](double h) {
        return over_cells(
            [&](double v) {
                return table(radians_to_degrees(v), radians_to_degrees(h)) * area(v, h);
            },
            vertical);
    };
    return over_cells(of_plane, horizontal);
}

/// lm of a web of type C up to a vertical angle in radians.
double flux_of_type_c(const IntensityTable& table, double last) {
    Breaks planes;
    for (const double h : in_radians(table.horizontal()))
        for (const double x : {h, pi - h, pi + h, 2 * pi - h}) planes.push_back(x);
    const Breaks all = in_radians(table.vertical());
    if (!(all.front() < last)) return 0;
    const Breaks vertical = between(all, all.front(), std::min(all.back(), last));
    return flux_over(table, vertical, between(std::move(planes), 0, 2 * pi),
                     [](double v, double) { return std::sin(v); });
}

} // namespace

double luminous_flux(const PhotometricWeb& web) {
    const IntensityTable& table = web.candela;
    if (web.type == PhotometricType::c) return flux_of_type_c(table, pi);
    const Breaks planes = in_radians(table.horizontal()), vertical = in_radians(table.vertical());
    Breaks both = planes;
    double first = planes.front();
    if (table.symmetry() == PlaneSymmetry::lateral) {
        first = -planes.back();
        for (const double h : planes) both.push_back(-h);
    }
    both = between(std::move(both), first, planes.back());
    if (web.type == PhotometricType::a)
        return flux_over(table, vertical, both, [](double v, double) { return std::cos(v); });
    return flux_over(table, vertical, both, [](double, double h) { return std::cos(h); });
}

double downward_flux(const PhotometricWeb& web) {
    assert(web.type == PhotometricType::c);
    return flux_of_type_c(web.candela, pi / 2);
}

} // namespace keiko
