#pragma once

#include "keiko/geometry/bezier/bezier.h"
#include "keiko/math/affine.h"

#include <limits>
#include <vector>

namespace keiko::test {

/// The arithmetic of references: 11 bits more than the double that is on trial.
using Long = long double;
static_assert(std::numeric_limits<Long>::digits >= 64, "references need more than double");
constexpr Long long_epsilon = std::numeric_limits<Long>::epsilon();

using LongVec3 = Imath::Vec3<Long>;

inline LongVec3 lengthened(const Vec3& v) {
    return {v.x, v.y, v.z};
}
inline Vec3 shortened(const LongVec3& v) {
    return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

/// A Bezier patch evaluated in long double from the same control points as the tracer's, by sums
/// of Bernstein polynomials. Shares no code with the library.
class ExactPatch {
public:
    explicit ExactPatch(const BezierPatchView& patch, const Affine& to_world = {});

    struct Point {
        LongVec3 position, du, dv; ///< world, mm

        LongVec3 normal() const { return du.cross(dv).normalized(); }
    };
    /// u and v may lie a little outside [0, 1].
    Point at(Long u, Long v) const;

    /// Bound of what rounding moves a position by, mm. The sum has positive weights, so it cannot
    /// lose more than its own steps whatever the weights are.
    Long rounding() const { return rounding_; }
    /// Largest extent of the control points from their middle, mm.
    Long radius() const { return radius_; }
    const Box3& bounds() const { return bounds_; }

private:
    struct Weighted {
        LongVec3 p; ///< weight times place relative to center_
        Long w;
    };
    int degree_u_, degree_v_;
    std::vector<Weighted> points_;
    LongVec3 center_{0};
    Box3 bounds_;
    Long radius_ = 0, rounding_ = 0;
};

} // namespace keiko::test
