#pragma once

#include "keiko/math/vec.h"

#include <cmath>

namespace keiko {

// What formulas ask of a number beyond its operators. Templates over `Real` find these for double,
// and the functions of the same names in batch.h for a batch of doubles. All agree to the bit.

/// Type of a comparison: bool, or a bool a lane. Lanes have no short cuts: && and || evaluate both.
template <class Real>
using MaskOf = decltype(Real() < Real());

/// `a` where the mask holds, `b` elsewhere.
inline double select(bool mask, double a, double b) {
    return mask ? a : b;
}
/// True if the mask holds in any lane.
inline bool any_of(bool mask) {
    return mask;
}
/// The lesser number; the second if either is NaN.
inline double min(double a, double b) {
    return a < b ? a : b;
}
/// The greater number; the second if either is NaN.
inline double max(double a, double b) {
    return a > b ? a : b;
}
/// Absolute value.
inline double abs(double x) {
    return std::abs(x);
}
/// Square root.
inline double sqrt(double x) {
    return std::sqrt(x);
}
/// Largest integer that is not greater.
inline double floor(double x) {
    return std::floor(x);
}
/// Least integer that is not less.
inline double ceil(double x) {
    return std::ceil(x);
}
/// The size of the first number with the sign of the second.
inline double copysign(double size, double sign) {
    return std::copysign(size, sign);
}
/// False for NaN and infinite numbers.
inline bool is_finite(double x) {
    return std::isfinite(x);
}

/// A number moved into [low, high]; `low` for NaN.
template <class Real>
Real clamped(const Real& x, double low, double high) {
    return min(max(x, Real(low)), Real(high));
}
/// (|x| + |y|) / 2: the largest change over half a unit of both ways.
template <class Real>
Real half_sum(const Real& x, const Real& y) {
    return (abs(x) + abs(y)) * 0.5;
}
/// Euclidean length.
template <class Real>
Real norm(const Vec3T<Real>& v) {
    return sqrt(v.length2());
}

} // namespace keiko
