#pragma once

#include "keiko/visibility/boundaries/boundary_piece.h"
#include "keiko/visibility/boundaries/plane_cuts.h"

#include <optional>

namespace keiko {

/// Axes at a light: z to the eye.
struct EpipolarAxes {
    Vec3 light{0};         ///< origin, world, mm
    Vec3 x{0}, y{0}, z{0}; ///< unit, at right angles, right-handed

    /// Axes at a light for an eye at another place.
    EpipolarAxes(const Vec3& at, const Vec3& eye);
    /// Coordinates of a world place in the axes, mm.
    Vec3 local(const Vec3& place) const {
        const Vec3 way = place - light;
        return {x.dot(way), y.dot(way), z.dot(way)};
    }
};

/// A segment in its half-plane from the axis: places are distances off the axis and along it.
struct EpipolarRay {
    Vec2 off{1, 0};        ///< unit, across the axis: where the half-plane goes
    Vec2 begin{0}, end{0}; ///< mm
    int sense = 1;         ///< 1 where the plane's normal is off turned by a right angle, else -1

    /// Segment of a plane that holds the axis, as one through the light and a segment of a ray from
    /// the eye does.
    EpipolarRay(const EpipolarAxes& axes, const SegmentPlane& plane);
    /// Parameter of the segment's place that a place of the half-plane hides from the light, as
    /// SegmentPlane::hidden_by.
    std::optional<double> hidden_by(const Vec2& place) const;
};

/// A curve of degree 5 that a light sees edge-on, as the planes of its pencil cut it.
class EpipolarCurve {
public:
    /// Curve of a border, a crease or an outline; the line itself is not kept.
    EpipolarCurve(const EpipolarAxes& axes, const BoundaryPiece& line);

    /// Calls `visit(t, event)` for each place t of the curve at which it hides some of the ray.
    template <class Visit>
    void each_event(const EpipolarRay& ray, const Visit& visit) const {
        each_cut(ray.off, [&](double t, int rising) {
            const Vec3 at = place(t);
            const double ahead = ray.off.x * at.x + ray.off.y * at.y;
            if (const auto s = ray.hidden_by({ahead, at.z}))
                visit(t, VisibilityEvent{*s, ray.sense * rising * side_});
        });
    }

private:
    static constexpr std::size_t points = BoundaryPiece::points;

    /// Calls `visit(t, rising)` where the plane that goes `off` the axis cuts the curve, as
    /// PlaneCut states. It is 0 next to the curve's ends, too: there the line that goes on may know
    /// better what is dark.
    template <class Visit>
    void each_cut(const Vec2& off, const Visit& visit) const {
        PlaneDistances c;
        for (std::size_t i = 0; i < points; ++i) c[i] = off.x * y_[i] - off.y * x_[i];
        constexpr double settled = 1e-4, next_to_end = 0.01;
        keiko::each_cut(c, slack_, settled, [&](const PlaneCut& cut) {
            const bool sure = cut.t > next_to_end && cut.t < 1 - next_to_end;
            visit(cut.t, sure ? cut.rising : 0);
        });
    }
    Vec3 place(double t) const;
    static int side_of(const EpipolarAxes& axes, const BoundaryPiece& line);

    PlaneDistances x_{}, y_{}, z_{}; ///< control points, mm from the light
    double slack_;                   ///< mm
    int side_; ///< on which the surface lies, of the curve's direction; 0 unknown
};

} // namespace keiko
