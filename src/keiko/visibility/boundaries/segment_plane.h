#pragma once

#include "keiko/geometry/visibility/viewpoint.h"

#include <optional>

namespace keiko {

/// A place along a segment where what a viewpoint sees of it may change.
struct VisibilityEvent {
    double t = 0;
    /// Where the surface that makes the event hides the segment next to t: -1 below, 1 above,
    /// 0 unknown.
    int dark = 0;
};

/// The plane through a viewpoint and a segment from a to b, in which everything lies that can hide
/// any of the segment.
class SegmentPlane {
public:
    /// Nothing where the viewpoint is on the line of the segment to within rounding.
    static std::optional<SegmentPlane> through(const Viewpoint& viewpoint, const Vec3& a,
                                               const Vec3& b) {
        const Vec3 along = b - a, way = viewpoint.way_to(a);
        const Vec3 normal = way.cross(along);
        const double sine = normal.length();
        constexpr double end_on = 1e-12;
        if (!(sine > end_on * way.length() * along.length())) return std::nullopt;
        return SegmentPlane(viewpoint, a, along, normal / sine);
    }

    const Viewpoint& viewpoint() const { return *viewpoint_; }
    const Vec3& normal() const { return normal_; }
    const Vec3& along() const { return along_; }
    Vec3 at(double t) const { return a_ + along_ * t; }
    /// What weighs homogeneous coordinates relative to `center` into the distance to the plane.
    Vec4 weights(const Vec3& center) const {
        return {normal_.x, normal_.y, normal_.z,
                normal_.dot(center - (viewpoint_->infinite() ? a_ : viewpoint_->place()))};
    }

    /// Parameter t of the place that x, in the plane, hides (docs/theory/visibility.md#events);
    /// nothing when x is not between the viewpoint and that place, or that place is not on the
    /// segment.
    std::optional<double> hidden_by(const Vec3& x) const {
        const Vec3 way = viewpoint_->way_to(x);
        const Vec3 to_a = way.cross(a_ - x), to_b = way.cross(along_);
        const double t = -to_a.dot(to_b) / to_b.dot(to_b);
        if (!(t >= 0 && t <= 1)) return std::nullopt;
        const Vec3 beyond = at(t) - x;
        const bool between = beyond.dot(way) > 0 && way.dot(viewpoint_->way_to(at(t))) > 0;
        return between ? std::optional(t) : std::nullopt;
    }

private:
    SegmentPlane(const Viewpoint& viewpoint, const Vec3& a, const Vec3& along, const Vec3& normal)
        : viewpoint_(&viewpoint), a_(a), along_(along), normal_(normal) {}

    const Viewpoint* viewpoint_;
    Vec3 a_, along_, normal_;
};

} // namespace keiko
