#include "keiko/light/luminance/rim.h"

#include "keiko/math/axes.h"
#include "keiko/math/quadrature.h"

#include <cmath>
#include <numbers>

// Key: the squared distance of a place is a + b cos(psi), a > b >= 0. N.(r x dr/dpsi) is
// alpha + beta cos(psi) + gamma sin(psi). The height of the rim above the horizon is
// lift + lift_cos cos(psi) + lift_sin sin(psi).

namespace keiko {
namespace {

using std::numbers::pi;

/// Unit vector across the axis of a disc in the direction of `level`, `aside` long. The rounding of
/// a place `far` away may leave a short one aslant, and that of a place on the axis anything.
Vec3 outwards_of(const Vec3& level, double aside, const Vec3& axis, double far) {
    constexpr double certain = 1e-7, nothing = 1e-14;
    if (aside > certain * far) return level / aside;
    const Vec3 straight = level - axis * axis.dot(level);
    if (straight.length() > nothing * far) return straight.normalized();
    return any_perpendicular(axis).normalized();
}

} // namespace

Rim::Rim(const Disc& disc, const Vec3& point, const Vec3& normal)
    : radius_(disc.radius), center_(disc.center - point) {
    const Vec3 level = center_ - disc.normal * disc.normal.dot(center_);
    const double aside = level.length();
    const Vec3 outwards = outwards_of(level, aside, disc.normal, center_.length());
    x_ = outwards * disc.radius;
    y_ = disc.normal.cross(outwards) * disc.radius;
    const double height2 = center_.length2() - aside * aside, r = disc.radius;
    a_ = height2 + aside * aside + r * r;
    b_ = 2 * aside * r;
    const double nearest2 = height2 + (aside - r) * (aside - r);
    a_b_ = std::sqrt(nearest2 * (height2 + (aside + r) * (aside + r)));
    alpha_ = r * r * normal.dot(disc.normal);
    beta_ = normal.dot(center_.cross(y_));
    gamma_ = -normal.dot(center_.cross(x_));
    lift_ = normal.dot(center_);
    lift_cos_ = normal.dot(x_);
    lift_sin_ = normal.dot(y_);
}

Vec3 Rim::at(double psi) const {
    return center_ + x_ * std::cos(psi) + y_ * std::sin(psi);
}

double Rim::angle_of(const Vec3& direction) const {
    return std::atan2(direction.dot(y_), direction.dot(x_));
}

double Rim::height(double psi) const {
    return lift_ + lift_cos_ * std::cos(psi) + lift_sin_ * std::sin(psi);
}

double Rim::lowest() const {
    return lift_ - std::hypot(lift_cos_, lift_sin_);
}

bool Rim::meets_horizon() const {
    return std::abs(lift_) < std::hypot(lift_cos_, lift_sin_);
}

ParameterInterval Rim::above() const {
    const double highest = std::atan2(lift_sin_, lift_cos_);
    const double half = std::acos(-lift_ / std::hypot(lift_cos_, lift_sin_));
    return {highest - half, highest + half};
}

double Rim::kernel(double psi) const {
    const double c = std::cos(psi), s = std::sin(psi);
    return (alpha_ + beta_ * c + gamma_ * s) / (a_ + b_ * c);
}

double Rim::whole() const {
    return 2 * pi / a_b_ * (alpha_ - beta_ * b_ / (a_ + a_b_));
}

/// Integral of 1 / (a + b cos) from 0 to psi, -pi to pi.
double Rim::inverse_integral(double psi) const {
    return 2 / a_b_ * std::atan2((a_ - b_) * std::sin(psi / 2), a_b_ * std::cos(psi / 2));
}

/// Integral of 1 / (a + b cos) over any range of at most a full turn within [-2 pi, 2 pi].
double Rim::inverse_integral(double begin, double end) const {
    const auto from_zero = [&](double psi) {
        if (psi > pi) return inverse_integral(psi - 2 * pi) + 2 * pi / a_b_;
        if (psi < -pi) return inverse_integral(psi + 2 * pi) - 2 * pi / a_b_;
        return inverse_integral(psi);
    };
    return from_zero(end) - from_zero(begin);
}

/// The closed form loses digits like a / b, and the kernel is almost a sine where they are many.
double Rim::arc(double begin, double end) const {
    if (b_ < 0.03 * a_) return integrate([&](double psi) { return kernel(psi); }, begin, end, 32);
    const double inverse = inverse_integral(begin, end);
    const double cosines = ((end - begin) - a_ * inverse) / b_;
    const double sines = -std::log((a_ + b_ * std::cos(end)) / (a_ + b_ * std::cos(begin))) / b_;
    return alpha_ * inverse + beta_ * cosines + gamma_ * sines;
}

} // namespace keiko
