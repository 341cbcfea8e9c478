#pragma once

#include "keiko/base/export.h"
#include "keiko/geometry/model/surface_model.h"
#include "keiko/inspect/basics/placed_face.h"

#include <span>
#include <vector>

namespace KEIKO_API keiko {

/// A model whose every placed face is a face of its own, in world coordinates.
struct PlacedModel {
    SurfaceModel model;             ///< one part, placed once, where it is
    std::vector<PlacedFace> origin; ///< of its faces
};

/// Places the faces of all instances, instances outer; then moves everything by `motion`. A
/// mirrored instance turns its faces round, so that what was outside stays so. `chosen`: the only
/// faces of the model to place, ascending; empty: all.
PlacedModel placed_model(const SurfaceModel& model, const Affine& motion = {},
                         std::span<const std::uint32_t> chosen = {});

} // namespace keiko
