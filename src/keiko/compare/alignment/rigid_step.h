#pragma once

#include "keiko/math/affine.h"
#include "keiko/math/symmetric_eigen.h"

#include <array>
#include <vector>

namespace keiko {

/// A small rigid motion about a pivot: the turn times a length in mm, then the shift in mm.
using RigidTwist = std::array<double, 6>;

/// Sums up distances that a small rigid motion shall make smallest, by least squares.
class RigidStep {
public:
    /// Motions turn about `pivot`; `size` in mm makes turns and shifts alike.
    RigidStep(const Vec3& pivot, double size) : pivot_(pivot), size_(size) {}

    /// A place whose distance of `distance` mm grows along the unit vector `direction`.
    void add(const Vec3& place, const Vec3& direction, double distance, double weight);

    /// Orthonormal motions that the distances leave free: eigenvectors of the normal matrix whose
    /// eigenvalue is at most `share` of its trace.
    std::vector<RigidTwist> free_twists(double share) const;
    /// Motion that brings the places nearest; what free_twists(share) spans stays as it is.
    RigidTwist solution(double share) const;
    /// Motion that brings the places nearest among those that the orthonormal `twists` span.
    RigidTwist solution_within(const std::vector<RigidTwist>& twists) const;

    /// The screw motion of a twist, at its full length.
    Affine motion(const RigidTwist& twist) const;

    /// Point that motions turn about.
    const Vec3& pivot() const { return pivot_; }
    /// mm that a turn of one radian counts for.
    double size() const { return size_; }

private:
    Vec3 pivot_;
    double size_;
    SquareMatrix<6> matrix_{};
    RigidTwist right_{};
};

/// mm, about how far a twist moves a body.
double length_of(const RigidTwist& twist);

/// Share of a trace below which an eigenvalue of a normal matrix is rounding.
inline constexpr double rounding_share = 1e-13;

} // namespace keiko
