#pragma once

#include "keiko/geometry/model/surface_model.h"

#include <cstddef>
#include <optional>

namespace keiko {

/// A place of a face at which its normal turns within less than what is negligible.
struct NarrowTurn {
    double radius = 0; ///< mm: of the arc on which the normal would turn as far; at most negligible
    Vec3 place{0};     ///< world, mm
};

/// The narrowest turn of a placed face, within its trims: of all pairs of places no more than
/// `negligible` mm apart, the one whose normals turn on the smallest arc. It needs no bound of
/// curvatures, so that it also works where the parametrisation is nearly singular. Parts of patches
/// are cut until their normals lie in a cone, proved by the Bernstein coefficients of S_u x S_v, or
/// they are a small share of the negligible length. Turns within a cone are not found. Sides of
/// patches that are points have none within three times the negligible length. nullopt if there is
/// none, or if `most_cuts` parts were cut before.
std::optional<NarrowTurn> narrow_turn(const SurfaceModel& model, std::uint32_t instance,
                                      std::uint32_t face, double negligible,
                                      std::size_t most_cuts = 20000);

} // namespace keiko
