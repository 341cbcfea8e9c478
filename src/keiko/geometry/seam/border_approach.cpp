#include "keiko/geometry/seam/border_approach.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keiko {
namespace {

/// A chord of a border's polyline.
struct Chord {
    const Border& border;
    std::size_t index;

    const Vec3& from() const { return border.polyline.points[index]; }
    const Vec3& to() const { return border.polyline.points[index + 1]; }
    Vec3 along() const { return to() - from(); }
    BorderPlace at(double share) const {
        return {{border.loop, border.first + index, from() + along() * share}, along()};
    }
    /// The place nearest to a point.
    BorderPlace nearest(const Vec3& p) const { return at(nearest_on_segment(from(), to(), p)); }
    Box3 box() const {
        Box3 box;
        box.extend(from());
        box.extend(to());
        return box;
    }
};

constexpr double right_angle = std::numbers::pi / 2;

/// Radians; twice the turn of a polyline, as it is an estimate.
double most_turn(const CurvePolyline& line) {
    return std::min(2 * line.turn, right_angle);
}

/// True if a part of the chord `of` lies beside the chord `to`, lengthened by `slack` mm at both
/// ends.
bool lies_beside(const Chord& of, const Chord& to, double slack) {
    const Vec3 along = to.along();
    const double length = along.length();
    if (!(length > 0)) return true;
    const auto [low, high] =
        std::minmax({along.dot(of.from() - to.from()), along.dot(of.to() - to.from())});
    return high >= -slack * length && low <= (length + slack) * length;
}

class Approach {
public:
    Approach(const Border& a, const Border& b, double join)
        : a_(a),
          b_(b),
          join_(join),
          deviation_(a.polyline.deviation + b.polyline.deviation),
          reach_(join + deviation_),
          slack_a_(slack(a.polyline)),
          slack_b_(slack(b.polyline)),
          sin_between_(std::sin(std::min(
              parallel_borders + (most_turn(a.polyline) + most_turn(b.polyline)), right_angle))) {}

    BorderApproach run() const;

private:
    std::optional<SegmentApproach> approach(const Chord& a, const Box3& around_a,
                                            const Chord& b) const;
    /// True if one of the chords has a place that is square to one of the other.
    bool may_face(const Chord& a, const Chord& b) const {
        return lies_beside(a, b, slack_b_) || lies_beside(b, a, slack_a_);
    }
    /// mm beyond the ends of a border's chords in which places may be square to the border.
    double slack(const CurvePolyline& line) const {
        constexpr double rounding = 1e-5; // mm
        return deviation_ + rounding + reach_ * std::sin(most_turn(line));
    }
    bool may_run_alike(const Chord& a, const Chord& b, double share) const;
    bool run_alike_at(const BorderPlace& a, const BorderPlace& b) const {
        return (a.place.position - b.place.position).length() <= reach_ && run_alike(a, b, join_);
    }

    const Border &a_, &b_;
    double join_, deviation_;
    double reach_;             ///< mm, between chords of borders that are within `join_`
    double slack_a_, slack_b_; ///< slack() of either border
    double sin_between_;       ///< sine of the angle between chords of borders that run alike
};

BorderApproach Approach::run() const {
    const CurvePolyline &a = a_.polyline, &b = b_.polyline;
    const Box3 box = b.box().padded(join_ + a.deviation);
    BorderApproach result;
    std::vector<ParameterInterval> close;
    for (std::size_t i = 0; i + 1 < a.points.size(); ++i) {
        const Chord chord{a_, i};
        if (!chord.box().overlaps(box)) continue;
        const Box3 around = chord.box().padded(reach_);
        for (std::size_t j = 0; j + 1 < b.points.size(); ++j) {
            const auto nearest = approach(chord, around, {b_, j});
            if (!nearest) continue;
            if (close.empty() || close.back().begin != a.t[i])
                close.push_back({a.t[i], a.t[i + 1]});
            if (nearest->share > 0 && nearest->share < 1)
                result.nearest.push_back(a.t[i] + nearest->share * (a.t[i + 1] - a.t[i]));
        }
    }
    result.close = IntervalSet(std::move(close));
    std::sort(result.nearest.begin(), result.nearest.end());
    return result;
}

/// Closest approach of two chords; nullopt if the borders do not face each other there. `around_a`:
/// the box of what is within reach of `a`.
std::optional<SegmentApproach> Approach::approach(const Chord& a, const Box3& around_a,
                                                  const Chord& b) const {
    if (!around_a.overlaps(b.box()) || !may_face(a, b)) return std::nullopt;
    const SegmentApproach nearest = segment_approach(a.from(), a.to(), b.from(), b.to());
    if (nearest.distance > reach_ || !may_run_alike(a, b, nearest.share)) return std::nullopt;
    return nearest;
}

/// True if the borders may run alike along the chords: where these are nearest and at their ends.
bool Approach::may_run_alike(const Chord& a, const Chord& b, double share) const {
    if (nearly_parallel(a.along(), b.along(), sin_between_)) return true;
    for (const double x : {share, 0.0, 1.0}) {
        const BorderPlace on = a.at(x);
        if (run_alike_at(on, b.nearest(on.place.position))) return true;
    }
    for (const double x : {0.0, 1.0}) {
        const BorderPlace on = b.at(x);
        if (run_alike_at(a.nearest(on.place.position), on)) return true;
    }
    return false;
}

} // namespace

BorderApproach border_approach(const Border& a, const Border& b, double join) {
    return Approach(a, b, join).run();
}

} // namespace keiko
