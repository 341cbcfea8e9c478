#pragma once

#include "keiko/geometry/seam/seam_stretch.h"

#include <cstdint>

namespace keiko {

/// A stretch and the two borders that it joins; border a is the earlier.
struct SeamCandidate {
    std::uint32_t a = 0, b = 0;
    Stretch stretch;
};

/// What another candidate offers along a stretch of one border.
struct SeamOffer {
    const SeamCandidate* candidate;
    bool as_a;

    double parameter(const FacingPoints& p) const { return as_a ? p.t : p.s; }
};

/// How far apart two points are, as candidates compete: a far side of a sliver faces the neighbour
/// across the sliver's own material, which counts more.
double cost(const FacingPoints& p);
/// Cost of an offer at a parameter of its border, or infinity where it does not reach.
double cost_at(const SeamOffer& offer, double x);
/// The same of the distance in mm, only where what lies between is material.
double width_at(const SeamOffer& offer, double x);

} // namespace keiko
