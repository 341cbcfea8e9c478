#pragma once

#include "keiko/math/vec.h"

#include <array>

namespace keiko {

/// Some vector across v, which must not be zero; of any length.
inline Vec3 any_perpendicular(const Vec3& v) {
    return v.cross(std::abs(v.x) < 0.7 * v.length() ? Vec3(1, 0, 0) : Vec3(0, 1, 0));
}

/// A symmetric matrix of 3 x 3: a sum of weighted products of vectors with themselves.
struct SecondMoments {
    std::array<Vec3, 3> rows{Vec3(0), Vec3(0), Vec3(0)}; ///< of the matrix, from the first

    /// Adds `weight` times the product of v with itself.
    void add(const Vec3& v, double weight);
};

/// Unit eigenvectors by falling eigenvalue, right-handed, by Jacobi's rotations.
std::array<Vec3, 3> principal_axes(const SecondMoments& moments);

} // namespace keiko
