#include "keiko/geometry/model/closest_point.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

ClosestPoint foot_at(const SurfaceCurve& curve, const Vec3& p, double t) {
    ClosestPoint foot{.t = t, .point = curve.at(t), .distance = 0, .slip = 0};
    const Vec3 off = foot.point.position - p;
    foot.distance = off.length();
    const double speed = foot.point.first.length();
    foot.slip = speed > 0 ? std::abs(off.dot(foot.point.first)) / speed : 0;
    return foot;
}

double newton_step(const SurfaceCurve::Point& c, const Vec3& p) {
    const Vec3 off = c.position - p;
    const double square = c.first.dot(c.first);
    const double full = square + off.dot(c.second);
    // Near a centre of curvature the full derivative vanishes or changes its sign; Gauss-Newton is
    // used there.
    const double slope = full > 0.1 * square ? full : square;
    return -off.dot(c.first) / slope;
}

} // namespace

ClosestPoint closest_point(const SurfaceCurve& curve, const Vec3& p, double guess, double begin,
                           double end) {
    constexpr int max_steps = 20;
    const double low = std::min(begin, end), high = std::max(begin, end);
    ClosestPoint best = foot_at(curve, p, std::clamp(guess, low, high));
    for (int i = 0; i < max_steps; ++i) {
        double step = newton_step(best.point, p);
        if (!std::isfinite(step)) break;
        ClosestPoint next = foot_at(curve, p, std::clamp(best.t + step, low, high));
        // At the minimum itself the distance only rounds up and down.
        const double not_worse = best.distance * (1 + 1e-12) + 1e-12;
        for (int shorter = 0; shorter < 8 && next.distance > not_worse; ++shorter) {
            step /= 4;
            next = foot_at(curve, p, std::clamp(best.t + step, low, high));
        }
        if (!(next.distance <= not_worse)) break;
        const double moved = std::abs(next.t - best.t) * best.point.first.length();
        best = next;
        // Newton's next step would be about the square of this one.
        if (moved <= 1e-9) break;
    }
    return best;
}

} // namespace keiko
