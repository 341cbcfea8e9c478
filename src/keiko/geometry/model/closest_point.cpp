#include "keiko/geometry/model/closest_point.h"

#include "keiko/base/job.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

class PolylineMaker {
public:
    PolylineMaker(const SurfaceCurve& curve, double chord_error)
        : curve_(curve), chord_error_(chord_error) {}

    CurvePolyline make() {
        check_stop();
        // Four cells to begin with: a symmetric S crosses its chord in the middle.
        constexpr int first_cells = 4;
        add(0, curve_.at(0).position);
        for (int i = 0; i < first_cells; ++i)
            refine(double(i) / first_cells, result_.points.back(), double(i + 1) / first_cells,
                   curve_.at(double(i + 1) / first_cells).position, 0);
        return std::move(result_);
    }

private:
    void add(double t, const Vec3& point) {
        if (!result_.points.empty()) result_.length += (point - result_.points.back()).length();
        result_.t.push_back(t);
        result_.points.push_back(point);
    }

    void refine(double t0, const Vec3& p0, double t1, const Vec3& p1, int depth) {
        constexpr int max_depth = 8;
        const double t = (t0 + t1) / 2;
        const Vec3 p = curve_.at(t).position;
        const double sag = segment_distance(p0, p1, p), chord = (p1 - p0).length();
        // A sag of an eighth of the chord is a turn of about 60 degrees.
        const bool fine = sag <= chord_error_ && (8 * sag <= chord || chord <= chord_error_);
        if (fine || depth == max_depth) {
            result_.deviation = std::max(result_.deviation, sag);
            // Turn of an arc; a point has no direction to turn from.
            if (chord > 0) result_.turn = std::max(result_.turn, 2 * std::atan(2 * sag / chord));
            add(t1, p1);
            return;
        }
        refine(t0, p0, t, p, depth + 1);
        refine(t, p, t1, p1, depth + 1);
    }

    const SurfaceCurve& curve_;
    double chord_error_;
    CurvePolyline result_;
};

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

Box3 CurvePolyline::box() const {
    Box3 result;
    for (const Vec3& p : points) result.extend(p);
    return result.padded(deviation);
}

double CurvePolyline::distance(const Vec3& p) const {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        least = std::min(least, segment_distance(points[i], points[i + 1], p));
    return least;
}

double CurvePolyline::nearest(const Vec3& p) const {
    double best = std::numeric_limits<double>::infinity(), best_t = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        const double x = nearest_on_segment(points[i], points[i + 1], p);
        const Vec3 off = points[i] + (points[i + 1] - points[i]) * x - p;
        if (const double square = off.dot(off); square < best) {
            best = square;
            best_t = t[i] + (t[i + 1] - t[i]) * x;
        }
    }
    return best_t;
}

CurvePolyline make_polyline(const SurfaceCurve& curve, double chord_error) {
    return PolylineMaker(curve, chord_error).make();
}

double nearest_on_segment(const Vec3& p0, const Vec3& p1, const Vec3& p) {
    const Vec3 along = p1 - p0;
    const double square = along.dot(along);
    return square > 0 ? std::clamp((p - p0).dot(along) / square, 0.0, 1.0) : 0;
}

double segment_distance(const Vec3& p0, const Vec3& p1, const Vec3& p) {
    return (p0 + (p1 - p0) * nearest_on_segment(p0, p1, p) - p).length();
}

SegmentApproach segment_approach(const Vec3& p0, const Vec3& p1, const Vec3& q0, const Vec3& q1) {
    // The least distance is attained at an end of one of them, or where both lines are nearest.
    SegmentApproach best{segment_distance(q0, q1, p0), 0};
    const auto offer = [&](double distance, double share) {
        if (distance < best.distance) best = {distance, share};
    };
    offer(segment_distance(q0, q1, p1), 1);
    offer(segment_distance(p0, p1, q0), nearest_on_segment(p0, p1, q0));
    offer(segment_distance(p0, p1, q1), nearest_on_segment(p0, p1, q1));
    const Vec3 u = p1 - p0, v = q1 - q0, w = p0 - q0;
    const double uu = u.dot(u), uv = u.dot(v), vv = v.dot(v), uw = u.dot(w), vw = v.dot(w);
    const double determinant = uu * vv - uv * uv;
    const double x = (uv * vw - vv * uw) / determinant, y = (uu * vw - uv * uw) / determinant;
    if (x >= 0 && x <= 1 && y >= 0 && y <= 1) offer((w + u * x - v * y).length(), x);
    return best;
}

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
