#include "keiko/light/sky/window_overlap.h"

#include <algorithm>
#include <cmath>

namespace keiko {
namespace {

/// A cone of directions.
struct Cone {
    Vec3 axis{0};
    double half_angle = 0;
};

/// A cone from a point around places.
Cone cone_around(std::span<const Vec3> places, const Vec3& point) {
    Vec3 sum(0);
    for (const Vec3& place : places) sum += (place - point).normalized();
    Cone cone{sum.normalized(), 0};
    for (const Vec3& place : places)
        cone.half_angle = std::max(cone.half_angle, angle_between(cone.axis, place - point));
    return cone;
}

/// True if both may share a direction.
bool may_overlap(const Cone& a, const Cone& b) {
    constexpr double rounding = 1e-9;
    return angle_between(a.axis, b.axis) <= a.half_angle + b.half_angle + rounding;
}

/// Parts of a segment in the directions that a window shows from a point.
IntervalSet shown(const Window& window, const Vec3& point, const Segment& segment) {
    std::vector<double> ends{0, 1};
    for (std::size_t i = 0; i < window.corners.size(); ++i) {
        const Vec3 a = window.corners[i] - point;
        const Vec3 b = window.corners[(i + 1) % window.corners.size()] - point;
        const Vec3 side = a.cross(b);
        const double t = side.dot(segment.a - point) / side.dot(segment.a - segment.b);
        if (t > 0 && t < 1) ends.push_back(t);
    }
    std::sort(ends.begin(), ends.end());
    std::vector<ParameterInterval> parts;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
        const Vec3 way = segment.at((ends[i] + ends[i + 1]) / 2) - point;
        if (way_from_window(window, -way.normalized(), point))
            parts.push_back({ends[i], ends[i + 1]});
    }
    return IntervalSet(std::move(parts));
}

} // namespace

WindowOverlap::WindowOverlap(const Visibility& bodies, std::span<const Vec3> corners,
                             std::span<const Window> others, const Vec3& point)
    : bodies_(bodies), point_(point) {
    const Cone own = cone_around(corners, point);
    for (const Window& other : others)
        if (may_overlap(own, cone_around(other.corners, point))) others_.push_back(&other);
}

IntervalSet WindowOverlap::beside(const Segment& segment, const IntervalSet& seen) const {
    IntervalSet left = seen;
    for (const Window* other : others_)
        left = left.intersect(shown(*other, point_, segment).complement());
    return left;
}

IntervalSet WindowOverlap::intervals(const Segment& segment) const {
    return beside(segment, bodies_.intervals(segment));
}

std::vector<IntervalSet> WindowOverlap::intervals(std::span<const Segment> segments) const {
    std::vector<IntervalSet> all = bodies_.intervals(segments);
    for (std::size_t i = 0; i < all.size(); ++i) all[i] = beside(segments[i], all[i]);
    return all;
}

std::vector<std::optional<bool>> WindowOverlap::classify_prisms(
    std::span<const Prism> prisms) const {
    std::vector<std::optional<bool>> all = bodies_.classify_prisms(prisms);
    if (others_.empty()) return all;
    for (std::optional<bool>& visible : all)
        if (visible && *visible) visible.reset();
    return all;
}

std::vector<CriticalSlice> WindowOverlap::turns(const Prism& prism, const TurnRule& rule) const {
    std::vector<CriticalSlice> all = bodies_.turns(prism, rule);
    const Vec3 along = (prism[0].b - prism[0].a).normalized();
    for (const Window* other : others_)
        for (const Vec3& corner : other->corners) {
            const Vec3 way = corner - point_;
            all.push_back({way - along * along.dot(way), rule.spacing / 2, 0, true});
        }
    return all;
}

} // namespace keiko
