#pragma once

#include "keiko/math/bounds.h"

#include <array>
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

} // namespace keiko::subdivision
