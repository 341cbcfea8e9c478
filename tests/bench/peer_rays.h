#pragma once

#include "tests/bench/table.h"

namespace keiko::bench {

/// Rays against spheres that pierce each other: the quadratic of each sphere, Keiko's tracer,
/// division of patches in four with bounding spheres, and triangles in a uniform grid. Costs a ray
/// of one thread, and errors against the quadratic. `brief`: few rays.
Table peer_ray_table(bool brief);

/// Time on the clock by the number of threads.
Table thread_table(bool brief);

} // namespace keiko::bench
