#pragma once

#include "keiko/intersect/traversal/tracer.h"

#include "tests/support/exact_root.h"

#include <algorithm>
#include <vector>

namespace keiko::test {

/// Whether one of the hits is this root: within its own bound, and the reference's error.
inline bool among(const std::vector<Hit>& hits, const ExactRoot& root) {
    return std::any_of(hits.begin(), hits.end(), [&](const Hit& hit) {
        return (lengthened(hit.position) - root.position).length() <=
               static_cast<Long>(hit.position_bound) + root.error;
    });
}

inline bool any_tangential(const std::vector<Hit>& hits) {
    return std::any_of(hits.begin(), hits.end(),
                       [](const Hit& hit) { return has(hit.flags, HitFlags::tangential); });
}

} // namespace keiko::test
