#pragma once

#include "keiko/visibility/nets/scalar_net.h"
#include "keiko/visibility/nets/tangent_planes.h"

#include <algorithm>
#include <cmath>

namespace keiko {

/// A homogeneous net over x = 2 u - 1, y = 2 v - 1 in [-1, 1]^2 as its affine part and bounds of
/// the rest, component by component. The affine part is value + x along_x + y along_y. A function
/// that is linear in the components, such as the distance to a plane, is bounded by weighing them.
struct AffineBounds {
    Vec4 value{0};               ///< affine part in the middle of the square
    Vec4 along_x{0}, along_y{0}; ///< slopes of the affine part by x and y
    Vec4 off{0};                 ///< of the deviation from the affine part
    Vec4 slope{0};               ///< of the sum of the magnitudes of its derivatives by x and y

    /// Value, slopes, and their bounds for the function sum of weights[k] * component k.
    struct Weighed {
        double value;            ///< affine part in the middle
        double along_x, along_y; ///< slopes of the affine part
        double off;              ///< bound of the deviation from the affine part
        double slope;            ///< bound of the sum of the deviation's derivatives' magnitudes

        /// Lower bound of its values on [-1, 1]^2.
        double least() const { return value - std::abs(along_x) - std::abs(along_y) - off; }
        /// Upper bound of its values on [-1, 1]^2.
        double most() const { return value + std::abs(along_x) + std::abs(along_y) + off; }
        /// Whether it has no zero there.
        bool vanishes_nowhere() const {
            return std::abs(value) > std::abs(along_x) + std::abs(along_y) + off;
        }
    };
    /// Bounds of the sum of weights[k] * component k.
    Weighed weighed(const Vec4& weights) const {
        const Vec4 sizes = magnitudes(weights);
        return {weights.dot(value), weights.dot(along_x), weights.dot(along_y), sizes.dot(off),
                sizes.dot(slope)};
    }
};

/// Rounding of making the bounds, up to 1e-14 of the largest coefficient, is included.
AffineBounds affine_bounds(const HomogeneousNet& net);

/// The affine part of a net, and how it bends.
struct AffineNet : AffineBounds {
    /// Second derivatives: middle and half width of their range.
    Vec4 xx{0}, xy{0}, yy{0}, xx_range{0}, xy_range{0}, yy_range{0};
};

/// Affine part, bounds and second derivatives of a net; these are 0 where a degree is below theirs.
AffineNet affine_net(const HomogeneousNet& net);

/// A function over a box, in its [-1, 1]^2: mean slopes, how much they vary, and how much the slope
/// along each axis does, as a share of the slopes.
struct GradientBounds {
    AffineBounds::Weighed all; ///< the function itself with its mean slopes
    Vec2 bend;                 ///< by x and by y, each at most 1; NaN for a constant

    /// The axis along which halving a box of this size straightens the function more.
    unsigned axis_to_halve(const Vec2& size) const;
    /// Widens the bounds for a function that is within `error` of this one on a box whose sides
    /// here are these shares. It must be a polynomial of the tangent planes' degree: the
    /// bound is Markov's inequality.
    void add_error(double error, const Vec2& shares);
};

/// Slopes of a function over [-1, 1]^2 by the ranges of its derivatives' coefficients. Rounding is
/// not included.
GradientBounds slopes_of(const ScalarNet& net);

/// Affine parts of two functions f and g on [-1, 1]^2, with bounds of the rest, and their proofs
/// about common zeros.
class LinearizedSystem {
public:
    /// Share of a piece by which neighbours overlap, so that no zero falls between them.
    static constexpr double overlap = 1e-7;
    /// Below this variation there is at most one zero; with some room for rounding.
    static constexpr double proved = 0.95;
    /// Below this one Newton's method finds it from anywhere on the piece: one found outside shows
    /// that there is none inside.
    static constexpr double straight = 0.25;

    /// System of two functions on one piece. Where the mean Jacobian is singular nothing is proved.
    LinearizedSystem(const AffineBounds::Weighed& f, const AffineBounds::Weighed& g) {
        const double d = f.along_x * g.along_y - f.along_y * g.along_x, size = std::abs(d);
        root_ = Vec2(f.along_y * g.value - g.along_y * f.value,
                     g.along_x * f.value - f.along_x * g.value) /
                d;
        const double gx = std::abs(g.along_x), gy = std::abs(g.along_y);
        const double fx = std::abs(f.along_x), fy = std::abs(f.along_y);
        off_ = Vec2(gy * f.off + fy * g.off, gx * f.off + fx * g.off) / size;
        variation_ = std::max(gy * f.slope + fy * g.slope, gx * f.slope + fx * g.slope) / size;
    }

    /// True if no common zero is proved to lie on the piece or its overlap.
    bool root_is_outside() const {
        return std::abs(root_.x) - off_.x > 1 + overlap || std::abs(root_.y) - off_.y > 1 + overlap;
    }
    /// How far the Jacobian may be from its mean, preconditioned by it. Infinite or NaN where the
    /// mean is singular.
    double variation() const { return variation_; }
    /// The zero of the affine parts, moved into the square.
    Vec2 nearest_inside() const {
        return {std::clamp(root_.x, -1.0, 1.0), std::clamp(root_.y, -1.0, 1.0)};
    }

private:
    Vec2 root_, off_;
    double variation_;
};

} // namespace keiko
