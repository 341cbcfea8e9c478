#pragma once

#include "keiko/visibility/boundaries/boundary_piece.h"
#include "keiko/visibility/boundaries/plane_cuts.h"
#include "keiko/visibility/silhouettes/silhouette_events.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

namespace keiko {

/// A stretch of the outline that a viewpoint sees of a patch: the line along which it is seen
/// edge-on, as a curve of degree 5 through exact places of it, like a border.
struct ContourCurve {
    /// `inward`: to the side of the outline on which the viewpoint sees the patch. `error`: mm.
    BoundaryPiece line;
    std::uint32_t patch = 0; ///< into Silhouettes::patches
    bool trimmed = false;    ///< trim curves may cross it
    /// Control points of its place on that patch.
    std::array<Vec2, BoundaryPiece::points> places{Vec2(0), Vec2(0), Vec2(0),
                                                   Vec2(0), Vec2(0), Vec2(0)};

    /// Place on the patch at parameter t of the line.
    Vec2 place_at(double t) const;
};

/// How far a line may be from the outline: rad, as the viewpoint sees it.
constexpr double outline_error = 1e-7;

/// Appends the outline of a candidate, which overlaps those of its neighbours a little. It must be
/// proved to run across the piece as a graph of one of its parameters, and curves meet it to within
/// outline_error. False, with nothing appended, elsewhere: cusps, poles, and pieces that an outline
/// bends in. The viewpoint is a point, not at infinity.
bool append_contour(const Silhouettes& silhouettes, const SubPatchKernels& kernels,
                    const SilhouetteCandidate& candidate, const Viewpoint& viewpoint,
                    std::vector<ContourCurve>& outlines);

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

inline EpipolarAxes::EpipolarAxes(const Vec3& at, const Vec3& eye)
    : light(at), z((eye - at).normalized()) {
    const Vec3 least = std::abs(z.x) < 0.6 ? Vec3(1, 0, 0) : Vec3(0, 1, 0);
    x = z.cross(least).normalized();
    y = z.cross(x);
}

inline EpipolarRay::EpipolarRay(const EpipolarAxes& axes, const SegmentPlane& plane) {
    const Vec3 a = axes.local(plane.at(0)), b = axes.local(plane.at(1));
    const double to_a = std::hypot(a.x, a.y), to_b = std::hypot(b.x, b.y);
    off = to_a > to_b ? Vec2(a.x, a.y) / to_a : Vec2(b.x, b.y) / to_b;
    begin = Vec2(to_a, a.z), end = Vec2(to_b, b.z);
    sense = plane.normal().dot(axes.y * off.x - axes.x * off.y) > 0 ? 1 : -1;
}

inline std::optional<double> EpipolarRay::hidden_by(const Vec2& place) const {
    const double at_begin = begin.x * place.y - begin.y * place.x;
    const double at_end = end.x * place.y - end.y * place.x;
    const double s = at_begin / (at_begin - at_end);
    if (!(s >= 0 && s <= 1)) return std::nullopt;
    const Vec2 hidden = begin + (end - begin) * s;
    return (hidden - place).dot(place) > 0 ? std::optional(s) : std::nullopt;
}

inline EpipolarCurve::EpipolarCurve(const EpipolarAxes& axes, const BoundaryPiece& line)
    : slack_(line.error), side_(side_of(axes, line)) {
    for (std::size_t i = 0; i < points; ++i) {
        const Vec3 p = axes.local(line.center + line.curve[i]);
        x_[i] = p.x, y_[i] = p.y, z_[i] = p.z;
        slack_ = std::max(slack_, line.error + 1e-14 * p.length());
    }
}

/// Side on which a border is dark, as dark_side returns it, if that is the same all along.
inline int EpipolarCurve::side_of(const EpipolarAxes& axes, const BoundaryPiece& line) {
    constexpr double useless = 0.2, unsure = 1e-5;
    if (!(line.inward_error < useless)) return 0;
    int side = 0;
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const Vec3 way = (line.center + line.at(t) - axes.light).normalized();
        const double inward =
            line.inward_at(t).normalized().dot(line.derivative(t).normalized().cross(way));
        if (!(std::abs(inward) > unsure + 2 * line.inward_error)) return 0;
        const int here = inward > 0 ? 1 : -1;
        if (side + here == 0) return 0;
        side = here;
    }
    return side;
}

inline Vec3 EpipolarCurve::place(double t) const {
    BoundaryPiece::Curve curve{Vec3(0), Vec3(0), Vec3(0), Vec3(0), Vec3(0), Vec3(0)};
    for (std::size_t i = 0; i < points; ++i) curve[i] = {x_[i], y_[i], z_[i]};
    return point_on(curve, t);
}

} // namespace keiko
