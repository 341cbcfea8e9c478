#pragma once

#include "keiko/trace/tangent_planes.h"

namespace keiko {

/// A homogeneous net over x = 2 u - 1, y = 2 v - 1 in [-1, 1]^2 as its affine part
/// value + x along_x + y along_y and bounds of what is left, component by component: a function
/// that is linear in the components, such as the distance to a plane, is bounded by weighing them.
struct AffineNet {
    Vec4 value{0}, along_x{0}, along_y{0};
    Vec4 off{0};   ///< of the deviation from the affine part
    Vec4 slope{0}; ///< of the sum of the magnitudes of its derivatives by x and y
    /// Second derivatives: middle and half width of their range.
    Vec4 xx{0}, xy{0}, yy{0}, xx_range{0}, xy_range{0}, yy_range{0};

    /// Value, slopes, and their bounds for the function sum of weights[k] * component k.
    struct Weighed {
        double value, along_x, along_y, off, slope;

        /// Whether it has no zero on [-1, 1]^2.
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

/// Rounding of making the net, up to 1e-14 of its largest coefficient, is included.
AffineNet affine_net(const HomogeneousNet& net);

} // namespace keiko
