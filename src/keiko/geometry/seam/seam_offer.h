#pragma once

#include "keiko/geometry/seam/seam_stretch.h"

#include <cstdint>

namespace keiko {

/// A stretch and the two borders that it joins; border a is the earlier.
struct SeamCandidate {
    std::uint32_t a = 0, b = 0;
    Stretch stretch;
};

/// The facing points that another candidate provides along a stretch of one border.
struct SeamOffer {
    const SeamCandidate* candidate;
    bool as_a;

    double parameter(const FacingPoints& p) const { return as_a ? p.t : p.s; }
};

/// Distance of two points by which candidates compete: a far side of a sliver faces the neighbour
/// across the sliver's own material, which counts more.
double cost(const FacingPoints& p);
/// Cost of an offer at a parameter of its border, or infinity beyond its ends.
double cost_at(const SeamOffer& offer, double x);
/// Distance in mm of an offer at a parameter of its border, only where material lies between;
/// otherwise infinity.
double width_at(const SeamOffer& offer, double x);

} // namespace keiko
