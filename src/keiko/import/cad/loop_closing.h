#pragma once

#include "keiko/import/cad/wire_chain.h"

namespace keiko::cad {

/// Closed loops of a face and the rectangle of its parameters that its patches must cover.
struct ClosedLoops {
    std::vector<Chain> loops;
    Box2 domain;
};

/// Closes the chains of a face, one a wire, so that the even-odd rule gives its material:
/// chains once around a periodic surface are paired to a band, or closed along the pole or border
/// on their left; small openings are bridged; loops are moved by whole periods to where the
/// largest lies, and doubled where they cross its border. Without chains the natural domain is
/// the face. What was done is added to `log`. Throws Error for a chain around an infinite
/// surface that bounds nothing.
ClosedLoops close_loops(std::vector<Chain> chains, const ParameterSpace& space, RepairLog& log);

} // namespace keiko::cad
