#pragma once

#include "keiko/import/subdivision/limit_table.h"
#include "keiko/math/vec.h"

#include <functional>
#include <vector>

namespace keiko::subdivision {

/// A point of a surface at parameters (u, v).
using SurfaceSample = std::function<Vec3(double u, double v)>;

/// The tensor Bezier patch of a degree up to 4 through a surface at the (degree + 1)^2 points of
/// the uniform lattice over [0, 1]^2, u outer. Exact, up to rounding, for a polynomial of that
/// degree; a border is exact wherever it is such a polynomial.
std::vector<Vec3> fit_square(int degree, const SurfaceSample& surface);

/// The polynomial of total degree 4 through a surface at the 15 points of the uniform lattice over
/// the triangle u, v, 1 - u - v >= 0. It is exact on a border wherever the surface is such a
/// polynomial.
SurfaceSample triangle_polynomial(const SurfaceSample& surface);

/// A Bezier patch of the limit surface.
struct LimitPatch {
    Box2 box;                 ///< which parameters of its base face it covers
    int degree = 3;           ///< in both directions
    std::vector<Vec3> points; ///< u outer, relative to the table's centre
};

/// The patches of a table by base face, each face's in a fixed order.
std::vector<std::vector<LimitTable::Index>> patches_by_face(const LimitTable& table);

/// The Bezier patches of one patch of four sides: itself, or a few strips beside a crease of finite
/// sharpness. Together those of a base face fill its parameters [0, 1]^2.
std::vector<LimitPatch> quad_patches(const LimitTable& table, LimitTable::Index index);

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
