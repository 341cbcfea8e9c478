#pragma once

#include "keiko/visibility/nets/affine_bounds.h"

#include <algorithm>
#include <cmath>

namespace keiko {

/// What the affine parts of two functions f and g on [-1, 1]^2, with bounds of the rest, prove of
/// their common zeros.
class LinearizedSystem {
public:
    /// Of a piece: neighbours overlap by this much, so that no zero falls between them.
    static constexpr double overlap = 1e-7;
    /// Below this variation there is at most one zero; with some room for rounding.
    static constexpr double proved = 0.95;
    /// Below this one Newton's method finds it from anywhere on the piece: one found outside shows
    /// that there is none inside.
    static constexpr double straight = 0.25;

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
