#pragma once

#include "keiko/spotlight/beam_direction.h"
#include "keiko/spotlight/intensity_table.h"

#include <memory>
#include <variant>
#include <vector>

namespace keiko {

/// How the intensity falls off towards the rim of the beam ([000] eqs (4) to (6)).
enum class BeamEdge { sharp, soft, mixed };

/// The papers' edges: with s = (cos theta - cos g) / (1 - cos g), 1, s, or (1 - q) s + q.
struct EdgeProfile {
    BeamEdge edge = BeamEdge::soft;
    double q = 0.5; ///< share of the sharp edge where the edge is mixed

    bool operator==(const EdgeProfile&) const = default;
};

/// Warn's cos^c theta, for comparison; 0 beyond 90 degrees.
struct CosinePower {
    double exponent = 1;

    bool operator==(const CosinePower&) const = default;
};

/// c0 + c1 cos theta + c2 cos^2 theta ..., not below 0.
struct CosinePolynomial {
    std::vector<double> coefficients;

    bool operator==(const CosinePolynomial&) const = default;
};

/// A table over theta (V) and phi (H).
using TableProfile = std::shared_ptr<const IntensityTable>;

/// Intensity over the one that a lamp is given with, by direction.
using BeamProfile = std::variant<EdgeProfile, CosinePower, CosinePolynomial, TableProfile>;

/// Value of the polynomial at x, not below 0.
double polynomial_value(const CosinePolynomial& polynomial, double x);

/// Of the profile into a direction, with its phi in radians plus what the lamp is spun by, and
/// `rim` the versine of the beam's half angle there: 0 beyond it (physics 7.2).
double profile_share(const BeamProfile& profile, const BeamDirection& direction, double phi,
                     double rim);

} // namespace keiko
