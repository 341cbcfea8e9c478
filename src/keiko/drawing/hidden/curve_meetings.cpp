#include "keiko/drawing/hidden/curve_meetings.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

constexpr int most_steps = 30;

double clamped(double t, const CurveCourse& curve) {
    return std::clamp(t, 0.0, curve.end());
}

/// Solution (s, r) of min |w + s x - r y|.
Vec2 least_squares(const Vec3& x, const Vec3& y, const Vec3& w) {
    const double xx = x.dot(x), xy = x.dot(y), yy = y.dot(y), determinant = xx * yy - xy * xy;
    constexpr double parallel = 1e-14; // of the determinant of vectors at right angles
    if (!(determinant > parallel * xx * yy)) return Vec2(xx > 0 ? -x.dot(w) / xx : 0, 0);
    return Vec2(xy * y.dot(w) - yy * x.dot(w), xx * y.dot(w) - xy * x.dot(w)) / determinant;
}

} // namespace

CurveMeeting nearest_on(const CurveCourse& curve, const Vec3& place) {
    CurveMeeting best{0, 0, (curve.points.front() - place).length()};
    for (std::size_t i = 0; i + 1 < curve.points.size(); ++i) {
        const Vec3 chord = curve.points[i + 1] - curve.points[i];
        const double length2 = chord.length2();
        const double share =
            length2 > 0 ? std::clamp((place - curve.points[i]).dot(chord) / length2, 0.0, 1.0) : 0;
        const double distance = (curve.points[i] + chord * share - place).length();
        if (distance < best.distance) best = {static_cast<double>(i) + share, 0, distance};
    }
    for (int step = 0; step < most_steps; ++step) {
        const Vec3 run = curve.derivative(best.t), off = curve.at(best.t) - place;
        if (!(run.length2() > 0)) break;
        const double next = clamped(best.t - off.dot(run) / run.length2(), curve);
        const double moved = std::abs(next - best.t);
        best.t = next;
        if (moved < 1e-13 * (1 + next)) break;
    }
    best.distance = (curve.at(best.t) - place).length();
    return best;
}

CurveMeeting chord_approach(const CurveCourse& a, std::size_t i, const CurveCourse& b,
                            std::size_t j) {
    const Vec3 x = a.points[i + 1] - a.points[i], y = b.points[j + 1] - b.points[j];
    const Vec3 w = a.points[i] - b.points[j];
    double s = std::clamp(least_squares(x, y, w).x, 0.0, 1.0);
    const double yy = y.dot(y), xx = x.dot(x);
    double r = yy > 0 ? std::clamp(y.dot(w + x * s) / yy, 0.0, 1.0) : 0;
    s = xx > 0 ? std::clamp(x.dot(y * r - w) / xx, 0.0, 1.0) : 0;
    return {static_cast<double>(i) + s, static_cast<double>(j) + r, (w + x * s - y * r).length()};
}

CurveMeeting approach(const CurveCourse& a, const CurveCourse& b, CurveMeeting from) {
    for (int step = 0; step < most_steps; ++step) {
        const Vec2 way =
            least_squares(a.derivative(from.t), b.derivative(from.u), a.at(from.t) - b.at(from.u));
        const double t = clamped(from.t + way.x, a), u = clamped(from.u + way.y, b);
        const double moved = std::abs(t - from.t) + std::abs(u - from.u);
        from.t = t, from.u = u;
        if (moved < 1e-13 * (1 + t + u)) break;
    }
    from.distance = (a.at(from.t) - b.at(from.u)).length();
    return from;
}

std::optional<CurveMeeting> image_crossing(const CurveCourse& a, const CurveCourse& b,
                                           CurveMeeting from, const ImageProjection& projection) {
    constexpr double farthest = 2, longest = 0.25; // chords: from the start, and of a step
    constexpr double enough = 1e-12;               // of the parameters
    CurveMeeting now = from;
    for (int step = 0; step < most_steps; ++step) {
        const Vec3 p = a.at(now.t), q = b.at(now.u);
        const Vec2 x = projection.image_direction(p, a.derivative(now.t));
        const Vec2 y = projection.image_direction(q, b.derivative(now.u));
        const Vec2 off = projection.image(q).at - projection.image(p).at;
        const double area = x.cross(y);
        if (!(std::abs(area) > 0)) return std::nullopt;
        Vec2 way = Vec2(off.cross(y), off.cross(x)) / area;
        way *= std::min(1.0, longest / std::max(std::abs(way.x), std::abs(way.y)));
        const double t = clamped(now.t + way.x, a), u = clamped(now.u + way.y, b);
        const double moved = std::abs(t - now.t) + std::abs(u - now.u);
        now.t = t, now.u = u;
        if (std::abs(t - from.t) + std::abs(u - from.u) > farthest) return std::nullopt;
        if (moved <= enough * (1 + t + u)) {
            now.distance = (a.at(t) - b.at(u)).length();
            return now;
        }
    }
    return std::nullopt;
}

} // namespace keiko
