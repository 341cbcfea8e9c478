#pragma once

#include "keiko/geometry/bezier/bezier.h"

#include <vector>

namespace keiko {

/// First three homogeneous coordinates: of a tangent plane, its normal.
inline Vec3 spatial(const Vec4& p) {
    return {p.x, p.y, p.z};
}

/// A net of homogeneous coefficients that owns its points; as BezierPatchView.
struct HomogeneousNet {
    int degree_u = 0, degree_v = 0; ///< 0 or more
    std::vector<Vec4> points;       ///< (degree_u + 1) * (degree_v + 1) coefficients, u outer

    /// View of the points, valid while they stay.
    BezierPatchView view() const { return {degree_u, degree_v, points}; }
};

/// Highest degree of a patch whose tangent planes still fit the nets of Keiko.
constexpr int max_occluder_degree = (max_degree + 1) / 3;

/// The tangent planes of a patch H = (w S, w), as a patch of the dual space: T = H ^ H_u ^ H_v.
/// T.(X, 1) > 0 for a point X and T.(d, 0) > 0 for a direction d on the side that S_u x S_v points
/// to, and 0 where the surface is edge-on. The silhouettes from X are so the zeros of one
/// polynomial whose coefficients are linear in X. T has degrees 3 p - 1 and 3 q - 1; on a side that
/// is collapsed into a point it vanishes, and that factor is divided out. Requires degrees of 1 to
/// max_occluder_degree and positive weights.
HomogeneousNet tangent_planes(const BezierPatchView& patch);

/// Whether all tangent planes are one: the patch is flat, and no one sees a fold of it.
bool is_flat(const HomogeneousNet& planes);

} // namespace keiko
