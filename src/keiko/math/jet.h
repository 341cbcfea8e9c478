#pragma once

#include "keiko/math/interval.h"

#include <cmath>

namespace keiko {

/// A function of (u, v) with its first derivatives at a place (T = double) or their ranges over a
/// box (T = Interval); Jet<Jet<T>> has the second derivatives too. Arithmetic is that of
/// forward-mode differentiation [GriewankWalther2008, section 3.1], so a formula written once gives
/// values, derivatives and bounds.
template <class T>
struct Jet {
    T f{}, u{}, v{};

    Jet() = default;
    Jet(double constant) : f(constant), u(0.0), v(0.0) {}
    Jet(const T& value, const T& by_u, const T& by_v) : f(value), u(by_u), v(by_v) {}
};

using FirstJet = Jet<double>;

template <class T>
Jet<T> operator-(const Jet<T>& a) {
    return {-a.f, -a.u, -a.v};
}
template <class T>
Jet<T> operator+(const Jet<T>& a, const Jet<T>& b) {
    return {a.f + b.f, a.u + b.u, a.v + b.v};
}
template <class T>
Jet<T> operator-(const Jet<T>& a, const Jet<T>& b) {
    return {a.f - b.f, a.u - b.u, a.v - b.v};
}
template <class T>
Jet<T> operator*(const Jet<T>& a, const Jet<T>& b) {
    return {a.f * b.f, a.u * b.f + a.f * b.u, a.v * b.f + a.f * b.v};
}
template <class T>
Jet<T> operator*(const Jet<T>& a, double b) {
    return {a.f * b, a.u * b, a.v * b};
}
template <class T>
Jet<T> operator/(const Jet<T>& a, const Jet<T>& b) {
    const T quotient = a.f / b.f;
    return {quotient, (a.u - quotient * b.u) / b.f, (a.v - quotient * b.v) / b.f};
}

inline double square(double a) {
    return a * a;
}
template <class T>
Jet<T> square(const Jet<T>& a) {
    const T twice = a.f * 2.0;
    return {square(a.f), twice * a.u, twice * a.v};
}
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
    T x{}, y{}, z{};
};

template <class T>
Triple<T> operator+(const Triple<T>& a, const Triple<T>& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
Triple<T> operator-(const Triple<T>& a, const Triple<T>& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T>
Triple<T> operator*(const Triple<T>& a, const T& b) {
    return {a.x * b, a.y * b, a.z * b};
}
template <class T>
T dot(const Triple<T>& a, const Triple<T>& b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class T>
T length2(const Triple<T>& a) {
    return square(a.x) + square(a.y) + square(a.z);
}
template <class T>
Triple<T> cross(const Triple<T>& a, const Triple<T>& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

} // namespace keiko
