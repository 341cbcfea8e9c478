#pragma once

#include "keiko/import/subdivision/lattice_fit.h"
#include "keiko/import/subdivision/limit_patches.h"

namespace keiko::subdivision {

/// A triangle of a table by its own parameters, as a polynomial of total degree 4: a cap, which
/// is none, by one through it. Looks into the table.
SurfaceSample triangle_surface(const LimitTable& table, LimitTable::Index index);

/// The triangles of one base face of a Loop cage as tensor patches of degree 4 x 4, without loss:
/// a polynomial of total degree 4 after a bilinear map. Each triangle becomes three, cut at
/// its middle; only the one at the base face's first vertex is a single patch that collapses there.
///
/// The face's parameters are made so that its three borders are the borders of [0, 1]^2: v = 0,
/// u = 1 and v = 1, while u = 0 is the first vertex. Patches at a border run along it by the
/// parameter of the cage's edge; the others, which no border ever meets, lie in rows inside.
std::vector<LimitPatch> triangle_patches(const LimitTable& table,
                                         const std::vector<LimitTable::Index>& triangles);

} // namespace keiko::subdivision
