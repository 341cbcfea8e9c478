#pragma once

#include "keiko/inspect/basics/placed_face.h"

#include <span>

namespace keiko {

/// A model of some placed faces of another, without its edges: each is a part of its own, placed
/// once, in the order given.
SurfaceModel placed_subset(const SurfaceModel& model, std::span<const PlacedFace> faces);

} // namespace keiko
