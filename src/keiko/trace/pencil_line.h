#pragma once

#include "keiko/patch/bernstein_roots.h"
#include "keiko/trace/border_piece.h"
#include "keiko/trace/segment_plane.h"

#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace keiko {

/// Axes at a light: z to the eye.
struct PencilAxes {
    Vec3 light{0}, x{0}, y{0}, z{0};

    PencilAxes(const Vec3& at, const Vec3& eye);
    Vec3 local(const Vec3& place) const {
        const Vec3 way = place - light;
        return {x.dot(way), y.dot(way), z.dot(way)};
    }
};

/// A segment in its half-plane from the axis: places are distances off the axis and along it.
struct PencilRay {
    Vec2 off{1, 0};        ///< unit, across the axis: where the half-plane goes
    Vec2 begin{0}, end{0}; ///< mm
    int sense = 1;         ///< 1 where the plane's normal is off turned by a right angle, else -1

    PencilRay(const PencilAxes& axes, const SegmentPlane& plane);
    /// Parameter of the segment's place that a place of the half-plane hides from the light, as
    /// SegmentPlane::hidden_by.
    std::optional<double> hidden_by(const Vec2& place) const;
};

/// A curve of degree 5 that a light sees edge-on, as the planes of its pencil cut it.
class PencilLine {
public:
    PencilLine(const PencilAxes& axes, const BorderPiece& line);

    /// Calls `visit(t, event)` for each place t of the curve at which it hides some of the ray.
    template <class Visit>
    void each_event(const PencilRay& ray, const Visit& visit) const {
        each_cut(ray.off, [&](double t, int rising) {
            const Vec3 at = place(t);
            const double ahead = ray.off.x * at.x + ray.off.y * at.y;
            if (const auto s = ray.hidden_by({ahead, at.z}))
                visit(t, VisibilityEvent{*s, ray.sense * rising * side_});
        });
    }

private:
    static constexpr std::size_t points = BorderPiece::points;
    using Values = std::array<double, points>;

    /// Calls `visit(t, rising)` where the plane that goes `off` the axis cuts the curve: 1 where
    /// the curve comes through from below, -1 from above. 0 next to its ends: there the line that
    /// goes on may know better what is dark.
    template <class Visit>
    void each_cut(const Vec2& off, const Visit& visit) const {
        Values c;
        int changes = 0;
        for (std::size_t i = 0; i < points; ++i) c[i] = off.x * y_[i] - off.y * x_[i];
        for (std::size_t i = 1; i < points; ++i) changes += (c[i - 1] < 0) != (c[i] < 0);
        const auto sure = [](double t) { return t > 0.01 && t < 0.99; };
        if (std::abs(c.front()) <= slack_) visit(0.0, 0);
        if (std::abs(c.back()) <= slack_) visit(1.0, 0);
        if (changes == 1) {
            const double t = single_root(c);
            visit(t, sure(t) ? (c.back() > c.front() ? 1 : -1) : 0);
        } else if (changes > 1) {
            for (const double t : bernstein_roots(c, 0)) visit(t, sure(t) ? direction(c, t) : 0);
        }
    }
    /// The only zero of coefficients that change sign once.
    static double single_root(const Values& c);
    /// Sign of the slope.
    static int direction(const Values& c, double t);
    Vec3 place(double t) const;
    static int side_of(const PencilAxes& axes, const BorderPiece& line);

    Values x_{}, y_{}, z_{}; ///< control points, mm from the light
    double slack_;           ///< mm
    int side_;               ///< on which the surface lies, of the curve's direction; 0 unknown
};

} // namespace keiko
