#pragma once

#include "keiko/trace/hit.h"

#include <vector>

namespace keiko {

/// A hit and what tells whether a neighbouring patch or face may have found it too.
struct BorderHit {
    Hit hit;
    bool at_border = false; ///< of its leaf, or on a leaf that trim curves cross
    double seam_reach = 0;  ///< mm, of a seam hit: how far from its border it may be
};

/// Sorted hits of one ray without the doubles that overlapping borders make: neighbouring hits of
/// one instance, each at a border, no farther apart along the ray than their position bounds and
/// seam reaches together, and in space than twice that. The one that is not a seam hit is kept,
/// else the first. `speed` is the length of the ray's direction.
std::vector<Hit> merged(std::vector<BorderHit> hits, double speed);

} // namespace keiko
