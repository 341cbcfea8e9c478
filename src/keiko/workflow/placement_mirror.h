#pragma once

#include "keiko/geometry/model/surface_model.h"
#include "keiko/placement/place_lamps.h"
#include "keiko/scene/camera.h"
#include "keiko/scene/symmetry.h"

#include <optional>

namespace keiko {

/// The symmetry plane of the lamps, if there is one: all cameras' eyes and axes lie on it, and the
/// faces that count lie within the choice's distance of their images. It is the chosen one or, if
/// it is to be found, the first of those across y, x and z through the first eye. nullopt if
/// `where` contains planes that are not symmetric. Throws Cancelled.
std::optional<MirrorPlane> placement_mirror(const SurfaceModel& model,
                                            std::span<const Camera> cameras,
                                            const PlacementOptions& options,
                                            const SymmetryChoice& choice, const Job& job);

} // namespace keiko
