#pragma once

#include "keiko/light/spotlight/beam_direction.h"
#include "keiko/light/spotlight/intensity_table.h"

#include <memory>
#include <variant>
#include <vector>

namespace keiko {

/// Falloff of the intensity towards the rim of the beam [NishitaSpots, eq. 4 to 6].
enum class BeamEdge { sharp, soft, mixed };

/// Edges of the paper: with s = (cos theta - cos g) / (1 - cos g), 1, s, or (1 - q) s + q.
struct EdgeProfile {
    BeamEdge edge = BeamEdge::soft;
    double q = 0.5; ///< share of the sharp edge where the edge is mixed

    bool operator==(const EdgeProfile&) const = default;
};

/// Power of the cosine, cos^c theta [Warn1983], for comparison; 0 beyond 90 degrees.
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

/// Value of the profile into a direction: 0 beyond the rim (docs/theory/spotlights.md#profiles).
/// `phi` is that of the direction in radians plus the lamp's spin, `rim` the versine of the beam's
/// half angle there.
double profile_share(const BeamProfile& profile, const BeamDirection& direction, double phi,
                     double rim);

} // namespace keiko
