#include "keiko/patch/parameter_map.h"

#include <cmath>

namespace keiko {

// A standard-form rational quadratic arc of half angle h satisfies tan(phi / 2) = (2t - 1) T with
// T = tan(h / 2) and phi the angle from its middle (tanh and atanh for a hyperbola).

namespace {

double middle(const ParameterMap& m) {
    return (m.begin + m.end) / 2;
}
double quarter(const ParameterMap& m) {
    return (m.end - m.begin) / 4;
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
    const double s = 2 * t - 1;
    if (kind == Kind::circular) {
        const double k = std::tan(quarter(*this));
        return 4 * k / (1 + s * s * k * k);
    }
    if (kind == Kind::hyperbolic) {
        const double k = std::tanh(quarter(*this));
        return 4 * k / (1 - s * s * k * k);
    }
    return end - begin;
}

double ParameterMap::second_derivative(double t) const {
    const double s = 2 * t - 1;
    if (kind == Kind::circular) {
        const double k = std::tan(quarter(*this)), d = 1 + s * s * k * k;
        return -16 * k * k * k * s / (d * d);
    }
    if (kind == Kind::hyperbolic) {
        const double k = std::tanh(quarter(*this)), d = 1 - s * s * k * k;
        return 16 * k * k * k * s / (d * d);
    }
    return 0;
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
