#pragma once

#include "keiko/math/affine.h"

#include <array>

namespace keiko {

/// Sums up distances that a small rigid motion shall make smallest, by least squares.
class RigidStep {
public:
    /// Motions turn about `pivot`; `size` in mm makes turns and shifts alike.
    RigidStep(const Vec3& pivot, double size) : pivot_(pivot), size_(size) {}

    /// A place whose distance of `distance` mm grows along the unit vector `direction`.
    void add(const Vec3& place, const Vec3& direction, double distance, double weight);

    /// What brings the places nearest; directions that they leave free stay as they are.
    Affine motion() const;
    /// mm, about how far that moves the body.
    double length() const;

private:
    std::array<double, 6> solution() const;

    Vec3 pivot_;
    double size_;
    std::array<std::array<double, 6>, 6> matrix_{};
    std::array<double, 6> right_{};
};

} // namespace keiko
