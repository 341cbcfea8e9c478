#pragma once

#include "keiko/geometry/bernstein/bernstein.h"
#include "keiko/geometry/bernstein/de_casteljau.h"
#include "keiko/geometry/rays/ray.h"
#include "keiko/geometry/trim/trim_region.h"
#include "keiko/visibility/boundaries/boundary_piece.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <vector>

namespace keiko {

/// A place along a segment where what a viewpoint sees of it may change.
struct VisibilityEvent {
    double t = 0; ///< parameter of the segment, 0 to 1
    /// Side next to t on which the surface that makes the event hides the segment: -1 below, 1
    /// above, 0 unknown.
    int dark = 0;
};

/// The plane through a viewpoint and a segment from a to b, in which everything lies that can hide
/// any of the segment. Keeps a pointer to the viewpoint.
class SegmentPlane {
public:
    /// Plane through the viewpoint and the segment; nothing where the viewpoint is on its line to
    /// within rounding.
    static std::optional<SegmentPlane> through(const Viewpoint& viewpoint, const Vec3& a,
                                               const Vec3& b) {
        const Vec3 along = b - a, way = viewpoint.way_to(a);
        const Vec3 normal = way.cross(along);
        const double sine = normal.length();
        constexpr double end_on = 1e-12;
        if (!(sine > end_on * way.length() * along.length())) return std::nullopt;
        return SegmentPlane(viewpoint, a, along, normal / sine);
    }

    /// The viewpoint that the plane was made with.
    const Viewpoint& viewpoint() const { return *viewpoint_; }
    /// Unit normal: along the way to the segment's begin x along().
    const Vec3& normal() const { return normal_; }
    /// Vector from the segment's begin to its end, mm.
    const Vec3& along() const { return along_; }
    /// Place of the segment at parameter t, world, mm.
    Vec3 at(double t) const { return a_ + along_ * t; }
    /// Weights that turn homogeneous coordinates relative to `center` into the distance to the
    /// plane.
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

/// Bernstein coefficients of the distance of a border piece to a plane.
using PlaneDistances = std::array<double, BoundaryPiece::points>;

/// Intersection of a piece of a border with a plane.
struct PlaneCut {
    double t = 0; ///< parameter of the piece, 0 to 1
    /// 1 where the distance rises through zero, -1 where it falls; 0 where that is not known.
    int rising = 0;
};

/// Number of sign changes between neighbouring coefficients, zero counting as positive. Unless all
/// are 0 it is no less than the number of zeros in (0, 1).
int sign_changes(const PlaneDistances& c);
/// The zero of coefficients that change sign once. Newton's method, kept inside, runs until it
/// moves by no more than `settled`; the step after that is about its square.
double single_zero(const PlaneDistances& c, double settled);
/// The derivative over 5, of the same degree.
PlaneDistances slope_of(const PlaneDistances& c);
/// The value at t.
double value_at(const PlaneDistances& c, double t);

/// Calls `visit(PlaneCut)` for the zeros, of coefficients over [begin, end].
template <class Visit>
void each_zero(const PlaneDistances& c, double begin, double end, double settled, int most_halvings,
               const Visit& visit) {
    const int changes = sign_changes(c);
    if (changes == 0) return;
    const auto at = [&](double t) { return begin + (end - begin) * t; };
    if (changes == 1)
        return visit(PlaneCut{at(single_zero(c, settled)), c.back() > c.front() ? 1 : -1});
    if (most_halvings == 0) {
        const PlaneDistances slope = slope_of(c);
        for (const double t : bernstein_roots(c, 0))
            visit(PlaneCut{at(t), value_at(slope, t) > 0 ? 1 : -1});
        return;
    }
    const std::array halves = bernstein_parts(c);
    each_zero(halves[0], begin, at(0.5), settled, most_halvings - 1, visit);
    each_zero(halves[1], at(0.5), end, settled, most_halvings - 1, visit);
}

/// Calls `visit(PlaneCut)` where the curve turns back within `slack` of the plane.
template <class Visit>
void each_touch(const PlaneDistances& c, double begin, double end, double slack, int most_halvings,
                const Visit& visit) {
    const auto [low, high] = std::minmax_element(c.begin(), c.end());
    if (*low > slack || *high < -slack) return;
    const PlaneDistances slope = slope_of(c);
    const int turns = sign_changes(slope);
    if (turns == 0) return;
    if (turns == 1) {
        constexpr double settled = 1e-9;
        const double t = single_zero(slope, settled);
        if (std::abs(value_at(c, t)) <= slack) visit(PlaneCut{begin + (end - begin) * t, 0});
        return;
    }
    if (most_halvings == 0) return;
    const std::array halves = bernstein_parts(c);
    const double middle = (begin + end) / 2;
    each_touch(halves[0], begin, middle, slack, most_halvings - 1, visit);
    each_touch(halves[1], middle, end, slack, most_halvings - 1, visit);
}

/// Calls `visit(PlaneCut)` wherever rays in the plane may begin or cease to meet what is within
/// `slack` mm of the curve. Those are its zeros, places where it turns back at the plane, and its
/// ends at the plane, where pieces meet within rounding and a zero belongs to both. A curve that
/// lies in the plane as a whole has its ends alone: signs along it are rounding, and rays may meet
/// it or not.
template <class Visit>
void each_cut(const PlaneDistances& c, double slack, double settled, const Visit& visit) {
    const auto [low, high] = std::minmax_element(c.begin(), c.end());
    if (*low > slack || *high < -slack) return;
    if (std::abs(c.front()) <= slack) visit(PlaneCut{0, 0});
    if (std::abs(c.back()) <= slack) visit(PlaneCut{1, 0});
    if (*low >= -slack && *high <= slack) return;
    constexpr int most_halvings = 8;
    each_touch(c, 0, 1, slack, most_halvings, visit);
    each_zero(c, 0, 1, settled, most_halvings, visit);
}

/// Appends the events at which a border, seen from the viewpoint of `plane`, crosses its segment:
/// the zeros of m.(C(t) - P) (docs/theory/visibility.md#events). `regions` are those of the model's
/// faces.
void find_border_events(const BoundaryPiece& border, std::span<const TrimRegion> regions,
                        const SegmentPlane& plane, std::vector<VisibilityEvent>& events);

} // namespace keiko
