#pragma once

#include "keiko/base/job.h"
#include "keiko/import/subdivision/limit_table.h"
#include "keiko/math/bounds.h"
#include "keiko/math/vec.h"

#include <array>
#include <functional>
#include <memory>
#include <vector>

namespace keiko::subdivision {

/// The 4 x 4 control points of a uniform bicubic B-spline patch, v outer, as OpenSubdiv orders
/// them.
using SplineNet = std::array<Vec3, 16>;
/// The 4 x 4 control points of a bicubic Bezier patch, u outer.
using BezierNet = std::array<Vec3, 16>;

/// A polynomial piece of a spline patch over a box of its parameters.
struct SplinePiece {
    Box2 box;         ///< within [0, 1]^2 of the patch
    BezierNet points; ///< of the piece over its own [0, 1]^2
};

/// The sides of a patch as bits: v = 0, u = 1, v = 1, u = 0.
using SideMask = unsigned;

/// The patch as a Bezier patch. On the sides in `borders` the surface ends in a spline curve: the
/// row of control points beyond them is not read, it is the mirror image of the row inside.
BezierNet bezier_of_spline(SplineNet net, SideMask borders);

/// Bezier pieces of a patch beside an edge of finite sharpness, with nothing irregular beside it.
/// `crease`, a single bit, is the side along that edge. The surface is a tensor product, so the
/// edge's subdivision rules apply to the four rows alone. One piece is infinitely sharp, down to
/// 2^-floor(sharpness) of the width; the rest beside the edge is smooth, in two pieces where the
/// sharpness is fractional [Niessner2012].
std::vector<SplinePiece> pieces_beside_crease(const SplineNet& net, SideMask crease,
                                              double sharpness);

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

/// How far caps are from the limit surface, at parameters where a deeper table is exact.
struct CapError {
    double distance = 0; ///< mm, at equal parameters
    double height = 0;   ///< mm, along the normal: what distance is of shape
    double angle = 0;    ///< radians, between the normals

    /// Takes the larger of both for each of the three.
    void extend(const CapError& other);
};

/// Largest number of points that semi-sharp creases may need; about 4 GB in all.
constexpr std::size_t most_refined_points = 4'000'000;

/// A cage refined as deep as its caps need.
struct CapChoice {
    std::unique_ptr<LimitTable> table; ///< of that level, not null
    int level = 0;                     ///< of refinement, up to deepest_level
    std::vector<CapError> errors;      ///< a base face: at most
};

/// Refines until every cap is within its tolerances, measured against the deepest table, or to the
/// deepest level; then the errors are those of caps two levels before it, which bound them. Throws
/// Error for semi-sharp creases that ask for more than most_refined_points.
CapChoice choose_caps(const Cage& cage, const Job& job = {});

/// 1 for a regular face of the scheme, n for an n-gon of the Catmull-Clark scheme.
std::uint32_t base_faces(const Cage& cage, const CageFace& face);

} // namespace keiko::subdivision
