#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/intersect/hit/hit.h"

namespace keiko {

/// A root on a sub-patch that passed every test, with nothing evaluated there yet: what a search
/// finds. Tracer::evaluate makes a Hit of it.
struct Crossing {
    double t = std::numeric_limits<double>::infinity(); ///< of the ray; infinite: no hit
    std::uint32_t sub_patch = no_index;                 ///< index among the placed sub-patches
    std::uint32_t seam = no_index;                      ///< edge index, for seam hits
    Vec2 uv{0};                                         ///< of the sub-patch's own [0, 1]^2
    Vec2 error{0}; ///< bounds of the distance to the exact root
    HitFlags flags = HitFlags::none;

    explicit operator bool() const { return sub_patch != no_index; }
    /// Order of hits along a ray, total so that it does not depend on who was found first.
    bool before(const Crossing& other) const {
        return t < other.t || (t == other.t && sub_patch < other.sub_patch);
    }
};

} // namespace keiko
