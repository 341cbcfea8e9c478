#pragma once

#include "keiko/base/export.h"
#include "keiko/math/interval.h"
#include "keiko/math/vec.h"

#include <cmath>

namespace KEIKO_API keiko {

/// A function of (u, v) with its first derivatives at a place (T = double) or their ranges over a
/// box (T = Interval); Jet<Jet<T>> has the second derivatives too. Arithmetic is that of
/// forward-mode differentiation [GriewankWalther2008, section 3.1], so a formula written once gives
/// values, derivatives and bounds.
template <class T>
struct Jet {
    T f{}, u{}, v{}; ///< value, and derivatives by u and v

    Jet() = default;
    /// A constant.
    Jet(double constant) : f(constant), u(0.0), v(0.0) {}
    /// A value with its derivatives.
    Jet(const T& value, const T& by_u, const T& by_v) : f(value), u(by_u), v(by_v) {}
};

using FirstJet = Jet<double>; ///< Value and first derivatives at a place.

/// Negation.
template <class T>
Jet<T> operator-(const Jet<T>& a) {
    return {-a.f, -a.u, -a.v};
}
/// Sum.
template <class T>
Jet<T> operator+(const Jet<T>& a, const Jet<T>& b) {
    return {a.f + b.f, a.u + b.u, a.v + b.v};
}
/// Difference.
template <class T>
Jet<T> operator-(const Jet<T>& a, const Jet<T>& b) {
    return {a.f - b.f, a.u - b.u, a.v - b.v};
}
/// Product.
template <class T>
Jet<T> operator*(const Jet<T>& a, const Jet<T>& b) {
    return {a.f * b.f, a.u * b.f + a.f * b.u, a.v * b.f + a.f * b.v};
}
/// Product with a constant.
template <class T>
Jet<T> operator*(const Jet<T>& a, double b) {
    return {a.f * b, a.u * b, a.v * b};
}
/// Quotient; b must not hold 0.
template <class T>
Jet<T> operator/(const Jet<T>& a, const Jet<T>& b) {
    const T quotient = a.f / b.f;
    return {quotient, (a.u - quotient * b.u) / b.f, (a.v - quotient * b.v) / b.f};
}

/// The square of a number.
inline double square(double a) {
    return a * a;
}
/// The square of a jet.
template <class T>
Jet<T> square(const Jet<T>& a) {
    const T twice = a.f * 2.0;
    return {square(a.f), twice * a.u, twice * a.v};
}
/// Square root; the value must be above 0.
template <class T>
Jet<T> sqrt(const Jet<T>& a) {
    using std::sqrt;
    const T root = sqrt(a.f);
    const T twice = root * 2.0;
    return {root, a.u / twice, a.v / twice};
}

/// A vector in space of numbers, intervals or jets.
template <class T>
struct Triple {
    T x{}, y{}, z{}; ///< components
};

/// Sum of two vectors.
template <class T>
Triple<T> operator+(const Triple<T>& a, const Triple<T>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
/// Difference of two vectors.
template <class T>
Triple<T> operator-(const Triple<T>& a, const Triple<T>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
/// Product with a scalar.
template <class T>
Triple<T> operator*(const Triple<T>& a, const T& b) {
    return {a.x * b, a.y * b, a.z * b};
}
/// Scalar product.
template <class T>
T dot(const Triple<T>& a, const Triple<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Scalar product with a constant vector.
template <class T>
T dot(const Triple<T>& a, const Vec3& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
/// Squared length.
template <class T>
T length2(const Triple<T>& a) {
    return square(a.x) + square(a.y) + square(a.z);
}
/// Vector product.
template <class T>
Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

} // namespace keiko
