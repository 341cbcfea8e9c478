#pragma once

#include "keiko/trace/border_piece.h"
#include "keiko/trace/segment_plane.h"

#include <array>
#include <limits>
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
    double sense = 1;      ///< 1 where the plane's normal is off turned by a right angle, else -1

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
        Values off;
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (std::size_t i = 0; i < points; ++i) {
            off[i] = ray.off.x * y_[i] - ray.off.y * x_[i];
            low = std::min(low, off[i]), high = std::max(high, off[i]);
        }
        if (low > slack_ || high < -slack_) return;
        for (const Cut& cut : cuts(off)) {
            const Vec3 at = place(cut.t);
            const double ahead = ray.off.x * at.x + ray.off.y * at.y;
            if (const auto s = ray.hidden_by({ahead, at.z}); s && ahead > 0)
                visit(cut.t, VisibilityEvent{*s, cut.rising * side_ * (ray.sense > 0 ? 1 : -1)});
        }
    }

private:
    static constexpr std::size_t points = BorderPiece::points;
    using Values = std::array<double, points>;
    /// Where a plane cuts the curve; whether it comes through from below, 1, or from above, -1.
    struct Cut {
        double t = 0;
        int rising = 0;
    };
    class Cuts {
    public:
        void add(const Cut& cut) { cuts_[count_++] = cut; }
        auto begin() const { return cuts_.begin(); }
        auto end() const { return cuts_.begin() + static_cast<std::ptrdiff_t>(count_); }

    private:
        /// As many as the degree, each twice at most, and both ends.
        std::array<Cut, 2 * points> cuts_{};
        std::size_t count_ = 0;
    };
    Cuts cuts(const Values& off) const;
    Vec3 place(double t) const;
    static int side_of(const PencilAxes& axes, const BorderPiece& line);

    Values x_{}, y_{}, z_{}; ///< control points, mm from the light
    double slack_;           ///< mm
    int side_;               ///< on which the surface lies, of the curve's direction; 0 unknown
};

} // namespace keiko
