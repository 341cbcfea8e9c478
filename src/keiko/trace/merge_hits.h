#pragma once

#include "keiko/trace/hit.h"

#include <vector>

namespace keiko {

/// Sorted hits of one ray without the doubles that overlapping borders make: neighbouring hits of
/// one instance, each at the border of its patch or leaf, closer than their position bounds
/// together (and, for seam hits, than `join` mm). The one that is not a seam hit is kept, else
/// the first. `speed` is the length of the ray's direction.
struct BorderHit {
    Hit hit;
    bool at_border = false;
};
std::vector<Hit> merged(std::vector<BorderHit> hits, double speed, double join);

} // namespace keiko
