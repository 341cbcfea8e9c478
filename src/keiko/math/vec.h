#pragma once

#include "keiko/base/export.h"

#include <Imath/ImathVec.h>

#include <cmath>
#include <span>

namespace KEIKO_API keiko {

// Imath leaves default-constructed vectors undefined: write Vec3(0), and fill arrays of them.
using Vec2 = Imath::V2d; ///< Vector in a plane.
using Vec3 = Imath::V3d; ///< Vector in space.
/// Homogeneous point: (w x, w y, w z, w).
using Vec4 = Imath::V4d;
/// Vector in a plane of any kind of number: a double, or a batch of them.
template <class Real>
using Vec2T = Imath::Vec2<Real>;
/// Vector in space of any kind of number.
template <class Real>
using Vec3T = Imath::Vec3<Real>;

/// Dot product of a vector and one of any kind of number.
template <class Real>
Real dot(const Vec3& a, const Vec3T<Real>& b) {
    return Real(a.x) * b.x + Real(a.y) * b.y + Real(a.z) * b.z;
}

/// Angle between two vectors in radians, 0 to pi; accurate near both ends, unlike acos.
inline double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).length(), a.dot(b));
}

/// The part of a vector square to another; all of it where that is 0.
inline Vec3 square_to(const Vec3& v, const Vec3& line) {
    const double length2 = line.length2();
    return length2 > 0 ? v - line * (v.dot(line) / length2) : v;
}

/// Absolute values of the components.
inline Vec3 magnitudes(const Vec3& v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z)};
}
/// Absolute values of the components.
inline Vec4 magnitudes(const Vec4& v) {
    return {std::abs(v.x), std::abs(v.y), std::abs(v.z), std::abs(v.w)};
}

/// True if no component is infinite or NaN.
inline bool is_finite(const Vec3& v) {
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// Mirror direction of an incoming direction `d` at a surface with unit normal `n` of any side.
inline Vec3 reflect(const Vec3& d, const Vec3& n) {
    return d - n * (2 * d.dot(n));
}

/// The point of homogeneous coordinates; w must not be 0.
inline Vec3 euclidean(const Vec4& p) {
    return Vec3(p.x, p.y, p.z) / p.w;
}

/// The mean of points; requires at least one.
inline Vec3 middle_of(std::span<const Vec3> points) {
    Vec3 middle(0);
    for (const Vec3& point : points) middle += point / static_cast<double>(points.size());
    return middle;
}

} // namespace keiko
