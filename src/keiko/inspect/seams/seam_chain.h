#pragma once

#include "keiko/geometry/seam/boundary_curves.h"
#include "keiko/geometry/seam/seam.h"

#include <span>
#include <vector>

namespace keiko {

/// Groups seams of the same two placed faces that continue each other (goes_on, within `join` mm).
/// Many p-curve pieces of a file are a single seam to the viewer of the car, while a corner
/// separates two seams, and so does a strip between them. Each chain holds ascending indices into
/// `seams`; chains are ordered by their first.
std::vector<std::vector<std::uint32_t>> seam_chains(const BoundaryCurves& curves,
                                                    std::span<const Seam> seams, double join);

} // namespace keiko
