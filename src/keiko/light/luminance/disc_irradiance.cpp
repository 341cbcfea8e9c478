#include "keiko/light/luminance/disc_irradiance.h"

#include "keiko/math/quadrature.h"

#include <cmath>
#include <numbers>

// Key: psi runs along the rim from the place that is farthest from the point, so that the squared
// distance is a + b cos(psi), a > b >= 0. N.(r x dr/dpsi) is alpha + beta cos(psi) + gamma
// sin(psi), the height of the rim above the horizon is lift + lift_cos cos(psi) + lift_sin
// sin(psi).

namespace keiko {
namespace {

using std::numbers::pi;

struct Rim {
    double a = 0, b = 0;
    double alpha = 0, beta = 0, gamma = 0;
    double lift = 0, lift_cos = 0, lift_sin = 0;
    double a_b = 0; ///< sqrt(a^2 - b^2) from the least and the largest distance
    Vec3 center, x, y;

    Vec3 at(double psi) const { return center + x * std::cos(psi) + y * std::sin(psi); }
    double kernel(double psi) const {
        const double c = std::cos(psi), s = std::sin(psi);
        return (alpha + beta * c + gamma * s) / (a + b * c);
    }
};

Vec3 any_across(const Vec3& axis) {
    const Vec3 beside = std::abs(axis.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    return (beside - axis * axis.dot(beside)).normalized();
}

Rim rim_of(const Disc& disc, const Vec3& point, const Vec3& normal) {
    Rim rim;
    rim.center = disc.center - point;
    const Vec3 level = rim.center - disc.normal * disc.normal.dot(rim.center);
    const double aside = level.length();
    const Vec3 outwards = aside > 0 ? level / aside : any_across(disc.normal);
    rim.x = outwards * disc.radius;
    rim.y = disc.normal.cross(outwards) * disc.radius;
    const double height2 = rim.center.length2() - aside * aside, r = disc.radius;
    rim.a = height2 + aside * aside + r * r;
    rim.b = 2 * aside * r;
    const double nearest2 = height2 + (aside - r) * (aside - r);
    rim.a_b = std::sqrt(nearest2 * (height2 + (aside + r) * (aside + r)));
    rim.alpha = r * r * normal.dot(disc.normal);
    rim.beta = normal.dot(rim.center.cross(rim.y));
    rim.gamma = -normal.dot(rim.center.cross(rim.x));
    rim.lift = normal.dot(rim.center);
    rim.lift_cos = normal.dot(rim.x);
    rim.lift_sin = normal.dot(rim.y);
    return rim;
}

double whole_rim(const Rim& rim) {
    return 2 * pi / rim.a_b * (rim.alpha - rim.beta * rim.b / (rim.a + rim.a_b));
}

/// Integral of 1 / (a + b cos) from 0 to psi, -pi to pi.
double inverse_integral(const Rim& rim, double psi) {
    return 2 / rim.a_b *
           std::atan2((rim.a - rim.b) * std::sin(psi / 2), rim.a_b * std::cos(psi / 2));
}

/// The same over any range of at most a turn within [-2 pi, 2 pi].
double inverse_integral(const Rim& rim, double begin, double end) {
    const auto from_zero = [&](double psi) {
        if (psi > pi) return inverse_integral(rim, psi - 2 * pi) + 2 * pi / rim.a_b;
        if (psi < -pi) return inverse_integral(rim, psi + 2 * pi) - 2 * pi / rim.a_b;
        return inverse_integral(rim, psi);
    };
    return from_zero(end) - from_zero(begin);
}

/// Part of the rim. The closed form loses digits like a / b, and the kernel is all but a sine where
/// they are many.
double arc(const Rim& rim, double begin, double end) {
    if (rim.b < 0.03 * rim.a)
        return integrate([&](double psi) { return rim.kernel(psi); }, begin, end, 32);
    const double inverse = inverse_integral(rim, begin, end);
    const double cosines = ((end - begin) - rim.a * inverse) / rim.b;
    const double sines =
        -std::log((rim.a + rim.b * std::cos(end)) / (rim.a + rim.b * std::cos(begin))) / rim.b;
    return rim.alpha * inverse + rim.beta * cosines + rim.gamma * sines;
}

/// The chord lies in the horizon, whose great circle has the normal N.
double chord(const Vec3& from, const Vec3& to, const Vec3& normal) {
    return std::atan2(normal.dot(from.cross(to)), from.dot(to));
}

} // namespace

double projected_solid_angle(const Disc& disc, const Vec3& point, const Vec3& normal) {
    const Rim rim = rim_of(disc, point, normal);
    if (!(rim.a > rim.b) || !(disc.radius > 0)) return 0;
    const double swing = std::hypot(rim.lift_cos, rim.lift_sin);
    if (rim.lift >= swing) return std::abs(whole_rim(rim)) / 2;
    if (rim.lift <= -swing) return 0;
    const double highest = std::atan2(rim.lift_sin, rim.lift_cos);
    const double half = std::acos(-rim.lift / swing);
    const double begin = highest - half, end = highest + half;
    return std::abs(arc(rim, begin, end) + chord(rim.at(end), rim.at(begin), normal)) / 2;
}

} // namespace keiko
