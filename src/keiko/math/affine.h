#pragma once

#include "keiko/base/export.h"
#include "keiko/math/bounds.h"
#include "keiko/math/vec.h"

#include <array>

namespace KEIKO_API keiko {

/// Affine map p -> M p + t in double precision; mirrored (det < 0) and scaled maps are allowed.
struct Affine {
    std::array<Vec3, 3> rows{Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}; ///< of M
    Vec3 translation{0, 0, 0};                                             ///< mm

    /// Image of a point.
    Vec3 point(const Vec3& p) const { return vector(p) + translation; }
    /// Image of a vector: without the translation.
    Vec3 vector(const Vec3& v) const { return {rows[0].dot(v), rows[1].dot(v), rows[2].dot(v)}; }
    /// Image of a surface normal (not unit): the cofactor matrix times `n`. For a mirrored map it
    /// points to the side that the cross product of the mapped tangents points to.
    Vec3 normal(const Vec3& n) const;
    /// Homogeneous point (w p, w).
    Vec4 homogeneous(const Vec4& p) const;

    /// Determinant of the linear part.
    double determinant() const { return rows[0].dot(rows[1].cross(rows[2])); }
    /// True if it turns right hands into left ones.
    bool mirrored() const { return determinant() < 0; }
    /// True if it moves nothing.
    bool is_identity() const { return *this == Affine{}; }
    /// Requires a determinant that is not 0.
    Affine inverse() const;

    bool operator==(const Affine&) const = default;

    /// A motion by an offset in mm.
    static Affine translate(const Vec3& offset) { return {.translation = offset}; }
    /// Rotation by `radians` about the axis through the origin, right-handed.
    static Affine rotate(const Vec3& axis, double radians);
    /// A scaling about the origin.
    static Affine scale(double factor);
};

/// (a * b)(p) = a(b(p))
Affine operator*(const Affine& a, const Affine& b);

/// The box of the images of a box's corners.
Box3 transformed(const Affine& map, const Box3& box);

} // namespace keiko
