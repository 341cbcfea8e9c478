#pragma once

#include "tests/bench/table.h"

namespace keiko::bench {

/// Shadows of spheres that pierce each other over a floor, by every algorithm of meshes. Costs are
/// those of one thread for a light at a point. Pixels are counted that differ from rays and from
/// the exact spheres. Area lights follow. `brief`: few triangles.
Table shadow_table(bool brief);

} // namespace keiko::bench
