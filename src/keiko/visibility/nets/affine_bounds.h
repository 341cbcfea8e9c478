#pragma once

#include "keiko/visibility/nets/tangent_planes.h"

#include <cmath>

namespace keiko {

/// A homogeneous net over x = 2 u - 1, y = 2 v - 1 in [-1, 1]^2 as its affine part
/// value + x along_x + y along_y and bounds of what is left, component by component: a function
/// that is linear in the components, such as the distance to a plane, is bounded by weighing them.
struct AffineBounds {
    Vec4 value{0}, along_x{0}, along_y{0};
    Vec4 off{0};   ///< of the deviation from the affine part
    Vec4 slope{0}; ///< of the sum of the magnitudes of its derivatives by x and y

    /// Value, slopes, and their bounds for the function sum of weights[k] * component k.
    struct Weighed {
        double value, along_x, along_y, off, slope;

        /// What it may be on [-1, 1]^2.
        double least() const { return value - std::abs(along_x) - std::abs(along_y) - off; }
        double most() const { return value + std::abs(along_x) + std::abs(along_y) + off; }
        /// Whether it has no zero there.
        bool vanishes_nowhere() const {
            return std::abs(value) > std::abs(along_x) + std::abs(along_y) + off;
        }
    };
    Weighed weighed(const Vec4& weights) const {
        const Vec4 sizes = magnitudes(weights);
        return {weights.dot(value), weights.dot(along_x), weights.dot(along_y), sizes.dot(off),
                sizes.dot(slope)};
    }
};

/// Rounding of making the bounds, up to 1e-14 of the largest coefficient, is included.
AffineBounds affine_bounds(const HomogeneousNet& net);

} // namespace keiko
