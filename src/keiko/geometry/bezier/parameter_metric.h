#pragma once

#include "keiko/base/export.h"
#include "keiko/math/bounds.h"
#include "keiko/math/vec.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace KEIKO_API keiko {

/// Length of a small step in a parameter plane, mm: a surface's first fundamental form, or that of
/// its projection to a viewpoint.
class ParameterMetric {
public:
    /// Metric of the tangents, mm in a unit of u and of v.
    ParameterMetric(const Vec3& du, const Vec3& dv)
        : uu_(du.length2()),
          uv_(du.dot(dv)),
          vv_(dv.length2()),
          least_(least(vv_, du.cross(dv).length(), uu_), least(uu_, du.cross(dv).length(), vv_)) {}
    /// Metric of tangents at right angles with these lengths.
    explicit ParameterMetric(const Vec2& lengths)
        : ParameterMetric(Vec3(lengths.x, 0, 0), Vec3(0, lengths.y, 0)) {}

    /// Scalar product of two steps, mm2.
    double dot(const Vec2& a, const Vec2& b) const {
        return uu_ * a.x * b.x + uv_ * (a.x * b.y + a.y * b.x) + vv_ * a.y * b.y;
    }
    /// Length of a step, mm.
    double length(const Vec2& step) const { return std::sqrt(std::max(0.0, dot(step, step))); }
    /// The distance of a place to a box.
    double distance(const Vec2& p, const Box2& box) const {
        const Vec2 low = box.lower - p, high = box.upper - p;
        const Vec2 off(std::clamp(0.0, low.x, high.x), std::clamp(0.0, low.y, high.y));
        if (off == Vec2(0)) return 0;
        // The nearest place is on a side that faces p: Q falls all the way from there to p.
        double least = std::numeric_limits<double>::infinity();
        if (off.x != 0) {
            const double v = vv_ > 0 ? -uv_ * off.x / vv_ : 0;
            least = length({off.x, std::clamp(v, low.y, high.y)});
        }
        if (off.y == 0) return least;
        const double u = uu_ > 0 ? -uv_ * off.y / uu_ : 0;
        return std::min(least, length({std::clamp(u, low.x, high.x), off.y}));
    }
    /// Bound of the distance between any two places of a box of this extent.
    double across(const Vec2& extent) const {
        return std::sqrt(uu_ * extent.x * extent.x + 2 * std::abs(uv_) * extent.x * extent.y +
                         vv_ * extent.y * extent.y);
    }
    /// The shortest steps that advance by 1 in u, with any step in v, and by 1 in v.
    const Vec2& least() const { return least_; }

private:
    static double least(double other, double area, double own) {
        return other > 0 ? area / std::sqrt(other) : std::sqrt(own);
    }

    double uu_, uv_, vv_;
    Vec2 least_;
};

} // namespace keiko
