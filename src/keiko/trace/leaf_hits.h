#pragma once

#include "keiko/trace/hit.h"
#include "keiko/trace/traced_model.h"

#include <span>

namespace keiko {

/// A ray as it is traced: its start moved up to the model, so that what single precision and
/// cancellation cost stays small against the model however far off the eye is.
struct TracedRay {
    const Ray* ray = nullptr;
    double t_start = 0; ///< of the ray, at `start`
    Vec3 start{0};      ///< world, mm
    double error = 0;   ///< mm, bound of the distance of `start` to the exact ray
};

/// A root on a leaf that passed every test, not yet evaluated.
struct Candidate {
    double t = 0; ///< of the ray
    PlacedLeaf placed;
    Vec2 uv{0}, error{0}; ///< of the leaf's own [0, 1]^2
    HitFlags flags = HitFlags::none;
    std::uint32_t seam = no_index; ///< edge index, for seam hits

    /// Order of hits along a ray, total so that it does not depend on who was found first.
    bool before(const Candidate& other) const;
};

/// The hits of a ray on one leaf with t between t_min and min(t_max, `limit`), in no order,
/// without trimmed and excluded ones. Where the ray excludes a root, these are left out: roots
/// on its patch inside its box; and, on any patch of its instance, roots at either end of the
/// ray where the end is on the surface to within rounding. The second rule is what keeps a ray
/// that starts on a patch border from hitting the neighbour's copy of the same point; it is
/// measured across the surface, so that a concave surface met again at a low angle still counts.
/// Valid until the thread's next call.
std::span<const Candidate> leaf_hits(const TracedModel& model, const PlacedLeaf& placed,
                                     const TracedRay& ray, bool clipping_only, double limit);

/// Everything about a hit, in world coordinates.
Hit evaluated(const TracedModel& model, const Candidate& candidate, bool second_derivatives);

} // namespace keiko
