#pragma once

#include "keiko/base/export.h"
#include "keiko/math/vec.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace KEIKO_API keiko {

/// A direction relative to a lamp: theta is its angle to the axis, phi the angle about it.
struct BeamDirection {
    double versine = 0;  ///< 1 - cos theta, without cancellation for narrow beams
    double x = 0, y = 0; ///< sin theta cos phi, sin theta sin phi

    /// Cosine of theta.
    double cosine() const { return 1 - versine; }
    /// Angle to the axis, radians, 0 to pi.
    double theta() const { return std::atan2(std::hypot(x, y), cosine()); }
    /// Angle about the axis, radians, 0 to 2 pi; 0 on the axis.
    double phi() const {
        const double angle = std::atan2(y, x);
        return angle < 0 ? angle + 2 * std::numbers::pi : angle;
    }
};

/// 1 - cos of the angle between two unit vectors, without cancellation for small ones.
inline double versine(const Vec3& a, const Vec3& b) {
    return (a - b).length2() / 2;
}

/// Axis of a lamp and the directions of phi = 0 and 90 degrees; all unit, right-handed.
struct BeamFrame {
    Vec3 axis{0}, across{0}, up{0}; ///< unit, in the world

    /// Direction in this frame of a unit vector of the world.
    BeamDirection direction(const Vec3& unit) const {
        return {versine(unit, axis), unit.dot(across), unit.dot(up)};
    }
    /// Unit vector of the world under two angles in radians.
    Vec3 world(double theta, double phi) const {
        const double sine = std::sin(theta);
        return axis * std::cos(theta) + (across * std::cos(phi) + up * std::sin(phi)) * sine;
    }
};

/// The frame whose phi = 0 is the part of `reference` across the axis, turned back by `spin`
/// radians, which adds that to phi. A reference along the axis is replaced by the coordinate axis
/// that is least along it. NaN, which lights nothing, if the axis has no length.
inline BeamFrame beam_frame(const Vec3& along, Vec3 reference, double spin = 0) {
    const Vec3 axis = along / along.length();
    Vec3 across = reference - axis * reference.dot(axis);
    if (!(across.length() > 1e-9 * reference.length())) {
        const Vec3 size(std::abs(axis.x), std::abs(axis.y), std::abs(axis.z));
        reference = size.x <= std::min(size.y, size.z) ? Vec3(1, 0, 0)
                    : size.y <= size.z                 ? Vec3(0, 1, 0)
                                                       : Vec3(0, 0, 1);
        across = reference - axis * reference.dot(axis);
    }
    across /= across.length();
    const Vec3 up = axis.cross(across);
    if (spin == 0) return {axis, across, up};
    const double c = std::cos(spin), s = std::sin(spin);
    return {axis, across * c - up * s, across * s + up * c};
}

} // namespace keiko
