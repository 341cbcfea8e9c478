#pragma once

#include "keiko/intersect/traversal/tracer.h"

namespace keiko::test {

/// Box around the leaves of a tracer, which reach some way beyond the material: world, mm.
inline Box3 leaf_bounds(const Tracer& tracer) {
    Box3 all;
    for (const Box3& box : tracer.boxes()) all.extend(box);
    return all;
}

} // namespace keiko::test
