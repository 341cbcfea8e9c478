#pragma once

#include "tests/bench/table.h"

namespace keiko::bench {

/// Shadows of spheres that pierce each other over a floor, by every algorithm of meshes: cost of
/// one thread for a light at a point, and pixels that differ from rays and from the exact spheres.
/// Area lights follow. `brief`: few triangles.
Table shadow_table(bool brief);

} // namespace keiko::bench
