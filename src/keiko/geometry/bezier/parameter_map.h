#pragma once

#include "keiko/base/export.h"
#include "keiko/math/interval.h"

#include <cstdint>

namespace KEIKO_API keiko {

/// Map from a patch's own parameter t in [0, 1] to its face's parameter: the parameter of the CAD
/// surface, in which the p-curves are written. Rational quadratic arcs are not parametrised by
/// angle, so circles need a map that is not affine; with it a face keeps its exact p-curves and its
/// exact geometry.
struct ParameterMap {
    /// Form of the map.
    enum class Kind : std::uint8_t {
        affine,    ///< face = begin + t (end - begin)
        circular,  ///< a standard rational quadratic arc over the angles begin..end
        hyperbolic ///< a standard rational quadratic hyperbola arc over cosh/sinh parameters
    };

    Kind kind = Kind::affine;  ///< form of the map
    double begin = 0, end = 1; ///< face parameters, or angles, at t = 0 and t = 1

    /// Face parameter at t, and its first and second derivative by t.
    double to_face(double t) const;
    /// First derivative of to_face by t.
    double derivative(double t) const;
    /// Second derivative of to_face by t.
    double second_derivative(double t) const;
    /// Inverse of to_face.
    double to_patch(double face_parameter) const;

    bool operator==(const ParameterMap&) const = default;
};

/// Ranges of a map's first and second derivatives over a range of its patch's parameter.
struct ParameterRanges {
    Interval first, second; ///< derivative
};
/// Ranges of a map over the patch parameters `t`.
ParameterRanges parameter_ranges(const ParameterMap& map, const Interval& t);

} // namespace keiko
