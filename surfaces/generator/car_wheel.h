#pragma once

#include "shape_pool.h"

namespace keiko::fixtures {

/// The four wheels and the linings of their arches: tyre and rim disc, each of three patches of a
/// third of a turn, quintic around the axle and cubic along the profile.
std::vector<NamedFace> car_wheels(ShapePool& pool);

} // namespace keiko::fixtures
