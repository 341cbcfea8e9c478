#pragma once

#include "keiko/light/luminance/disc.h"
#include "keiko/math/interval_set.h"
#include "keiko/math/vec.h"

namespace keiko {

/// The rim of a disc viewed from a surface element, with Stokes' integral N.(r x dr) / r^2 along
/// parts of it in closed form (docs/theory/luminance.md#planar-polygons-and-discs). Angles psi
/// around the disc's normal count from the rim's place farthest from the point. Parts reach over at
/// most a full turn within [-2 pi, 2 pi].
class Rim {
public:
    /// The rim of a disc from `point` with unit `normal`; any unit of length.
    Rim(const Disc& disc, const Vec3& point, const Vec3& normal);

    /// True if the point lies in the disc's rim, or the disc is a point.
    bool edge_on() const { return !(a_ > b_) || !(radius_ > 0); }
    /// Place of the rim, from the point.
    Vec3 at(double psi) const;
    /// Angle of a direction from the disc's center, -pi to pi.
    double angle_of(const Vec3& direction) const;
    /// Height of a place above the tangent plane of the surface element.
    double height(double psi) const;
    /// Least height of all places.
    double lowest() const;
    /// True if some places are above the tangent plane and others are below.
    bool meets_horizon() const;
    /// The part above the tangent plane, where the rim meets it: begin < end.
    ParameterInterval above() const;
    /// Integral along the whole rim, rising.
    double whole() const;
    /// Integral along a part from `begin` to `end`.
    double arc(double begin, double end) const;

private:
    double kernel(double psi) const;
    double inverse_integral(double psi) const;
    double inverse_integral(double begin, double end) const;

    double radius_;
    double a_ = 0, b_ = 0;
    double alpha_ = 0, beta_ = 0, gamma_ = 0;
    double lift_ = 0, lift_cos_ = 0, lift_sin_ = 0;
    double a_b_ = 0; ///< sqrt(a^2 - b^2) from the least and the largest distance
    Vec3 center_{0}, x_{0}, y_{0};
};

} // namespace keiko
