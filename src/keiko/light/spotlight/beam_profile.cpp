#include "keiko/light/spotlight/beam_profile.h"

#include "keiko/base/units.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

struct Share {
    const BeamDirection& direction;
    double phi, rim;

    double operator()(const EdgeProfile& profile) const {
        const double soft = rim > 0 ? 1 - direction.versine / rim : 1;
        switch (profile.edge) {
            case BeamEdge::sharp:
                return 1;
            case BeamEdge::soft:
                return soft;
            case BeamEdge::mixed:
                return (1 - profile.q) * soft + profile.q;
        }
        return 0;
    }
    double operator()(const CosinePower& warn) const {
        return direction.versine < 1 ? std::pow(direction.cosine(), warn.exponent) : 0;
    }
    double operator()(const CosinePolynomial& polynomial) const {
        return polynomial_value(polynomial, direction.cosine());
    }
    double operator()(const TableProfile& table) const {
        return (*table)(radians_to_degrees(direction.theta()), radians_to_degrees(phi));
    }
};

} // namespace

double polynomial_value(const CosinePolynomial& polynomial, double x) {
    double value = 0;
    for (auto c = polynomial.coefficients.rbegin(); c != polynomial.coefficients.rend(); ++c)
        value = value * x + *c;
    return std::max(value, 0.0);
}

double profile_share(const BeamProfile& profile, const BeamDirection& direction, double phi,
                     double rim) {
    return direction.versine <= rim ? std::visit(Share{direction, phi, rim}, profile) : 0;
}

} // namespace keiko
