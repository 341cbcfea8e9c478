#pragma once

#include "keiko/geometry/bezier/bezier.h"

#include <vector>

namespace keiko {

/// Control points of the piece of a patch over a box of its parameters, u outer. The box may extend
/// a little beyond [0, 1]^2: the polynomials continue there.
std::vector<Vec4> subpatch(const BezierPatchView& patch, const Box2& box);

/// The point of a piece of surface that is nearest to a given one.
struct PieceProjection {
    Vec2 uv{0};             ///< in [0, 1]^2
    Vec3 position{0};       ///< mm
    double distance = 0;    ///< mm
    bool converged = false; ///< a local minimum within the unit square
};

/// Nearest point by Newton's iteration on |S(u, v) - p|^2 / 2 within the unit square, from `start`:
/// a local minimum, and the only one where the squared distance is convex.
PieceProjection piece_projection(const BezierPatchView& piece, const Vec3& p,
                                 const Vec2& start = Vec2(0.5));

} // namespace keiko
