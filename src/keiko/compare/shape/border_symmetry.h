#pragma once

#include "keiko/base/job.h"
#include "keiko/geometry/seam/seam.h"
#include "keiko/inspect/basics/placed_face.h"
#include "keiko/scene/symmetry.h"

#include <optional>
#include <span>

namespace keiko {

/// Limits of a search along borders.
struct BorderSearch {
    double limit = 0.01; ///< mm, to whose accuracy the largest distance is searched
    double reach = 0;    ///< mm: what is farther has no image
    double least = 0.1;  ///< mm: shorter free edges are not measured
    double join = 0.5;   ///< mm, of the seams
};

/// The place of a body's free borders that is farthest from their mirror image.
struct BorderDeviation {
    double distance = 0; ///< mm, at most the reach
    double hidden = 0;   ///< mm by which another place may be farther
    Vec3 place{0};       ///< world, mm, on the body
    PlacedFace face;     ///< whose border it is
};

/// Searches all free borders, those of a model's seams left out, for the largest distance from
/// their own mirror image. It is at most `limit` / 10, or at most `limit` / 1000 and `hidden` from
/// the largest. A body is as far from its image as that from the body: one way is both. nullopt for
/// a body without free borders. The same for any number of threads. Throws Cancelled.
std::optional<BorderDeviation> border_asymmetry(const SurfaceModel& model,
                                                std::span<const Seam> seams,
                                                const MirrorPlane& plane,
                                                const BorderSearch& search, const Job& job = {});

} // namespace keiko
