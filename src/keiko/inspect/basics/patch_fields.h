#pragma once

#include "keiko/geometry/bernstein/bernstein_field.h"
#include "keiko/geometry/bezier/bezier.h"

#include <array>
#include <vector>

namespace keiko {

/// A side of a patch's parameters along which a field is 0.
struct BoundaryFactor {
    bool by_u = true;   ///< u is fixed, else v
    bool upper = false; ///< at 1, else at 0
    int times = 1;      ///< its multiplicity: 2 and more where the slope across it is 0 as well
};

/// Divides `field` by its boundary factors: the sides along which it is at most `tolerance`, each
/// with its multiplicity. The other zeros stay as they are.
std::vector<BoundaryFactor> divide_sides(BernsteinField& field, double tolerance);

/// A vector over a patch whose coordinates are polynomials.
using FieldTriple = std::array<BernsteinField, 3>;

/// Cross product of two vectors at every place.
FieldTriple cross(const FieldTriple& a, const FieldTriple& b);
/// Scalar product of two vectors at every place.
BernsteinField dot(const FieldTriple& a, const FieldTriple& b);
/// The vector at the parameters `uv` of the patch.
Vec3 value_at(const FieldTriple& field, const Vec2& uv);

/// A patch in homogeneous coordinates, or a derivative of one.
struct HomogeneousField {
    FieldTriple p;    ///< w times the point, mm, or a derivative of that product
    BernsteinField w; ///< weight, or a derivative of it

    /// The derivative by u (`by_u`) or v.
    HomogeneousField derivative(bool by_u) const;
};

/// The patch in homogeneous coordinates. `rounding`: error of each of them, mm.
HomogeneousField homogeneous_field(const BezierPatchView& patch, double rounding);

/// S_u (`by_u`) or S_v of a patch times its weight squared, or its weight where all are equal.
FieldTriple tangent_field(const BezierPatchView& patch, bool by_u, double rounding);

/// S_u x S_v of a patch times its weight cubed, w^3, or w^2 where all weights are equal. Its
/// direction is the patch's normal, and it is 0 where the patch is singular.
FieldTriple normal_field(const BezierPatchView& patch, double rounding);

/// Divides a vector by the sides of the patch along which all of it is 0, each with its
/// multiplicity. The result has the same direction inside, and its limit on those sides.
/// Coefficients of up to 1e-9 of the largest count as 0: they change the field no farther inside
/// than that share of the patch.
FieldTriple without_zero_sides(FieldTriple field);

} // namespace keiko
