#include "keiko/geometry/bezier/parameter_map.h"

#include <cmath>

namespace keiko {
namespace {

// A standard-form rational quadratic arc of half angle h satisfies tan(phi / 2) = (2t - 1) T. Here
// T = tan(h / 2) and phi is the angle from its middle (tanh and atanh for a hyperbola).

double middle(const ParameterMap& m) {
    return (m.begin + m.end) / 2;
}
double quarter(const ParameterMap& m) {
    return (m.end - m.begin) / 4;
}

/// T of the map; 0 of an affine one.
double tangent(const ParameterMap& m) {
    if (m.kind == ParameterMap::Kind::circular) return std::tan(quarter(m));
    return m.kind == ParameterMap::Kind::hyperbolic ? std::tanh(quarter(m)) : 0;
}

double squared(double x) {
    return x * x;
}
Interval squared(const Interval& x) {
    return square(x);
}

/// 1 + (s T)^2 on a circle, 1 - (s T)^2 on a hyperbola, s = 2t - 1.
template <class T>
T divisor(const ParameterMap& m, const T& t) {
    const T reach = squared((t * 2.0 - 1.0) * tangent(m));
    return m.kind == ParameterMap::Kind::hyperbolic ? T(1.0) - reach : reach + 1.0;
}

template <class T>
T first_of(const ParameterMap& m, const T& t) {
    if (m.kind == ParameterMap::Kind::affine) return m.end - m.begin;
    return T(4 * tangent(m)) / divisor(m, t);
}

template <class T>
T second_of(const ParameterMap& m, const T& t) {
    if (m.kind == ParameterMap::Kind::affine) return 0.0;
    const double k = tangent(m), sign = m.kind == ParameterMap::Kind::circular ? -1 : 1;
    return (t * 2.0 - 1.0) * (sign * 16 * k * k * k) / squared(divisor(m, t));
}

} // namespace

double ParameterMap::to_face(double t) const {
    const double s = 2 * t - 1;
    switch (kind) {
        case Kind::circular:
            return middle(*this) + 2 * std::atan(s * std::tan(quarter(*this)));
        case Kind::hyperbolic:
            return middle(*this) + 2 * std::atanh(s * std::tanh(quarter(*this)));
        case Kind::affine:
            break;
    }
    return begin + t * (end - begin);
}

double ParameterMap::derivative(double t) const {
    return first_of(*this, t);
}

double ParameterMap::second_derivative(double t) const {
    return second_of(*this, t);
}

ParameterRanges parameter_ranges(const ParameterMap& map, const Interval& t) {
    return {first_of(map, t), second_of(map, t)};
}

double ParameterMap::to_patch(double face_parameter) const {
    const double half = (face_parameter - middle(*this)) / 2;
    switch (kind) {
        case Kind::circular:
            return (1 + std::tan(half) / std::tan(quarter(*this))) / 2;
        case Kind::hyperbolic:
            return (1 + std::tanh(half) / std::tanh(quarter(*this))) / 2;
        case Kind::affine:
            break;
    }
    return (face_parameter - begin) / (end - begin);
}

} // namespace keiko
