#include "keiko/base/job.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/seam/border_approach.h"
#include "keiko/geometry/seam/seam_candidate.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace keiko {
namespace {

/// mm: an end this near to another is the same end; CAD systems themselves join at 1e-7 to 1e-5.
constexpr double snap = 1e-6;

/// Parameters of an end; either end of a closed curve represents both, as a foot does not
/// distinguish them.
std::vector<double> ends_at(double t, bool closed) {
    if (closed && (t == 0 || t == 1)) return {0, 1};
    return {t};
}

/// Projection of a point of `a` to `b`.
struct Look {
    double t = 0, s = 0;
    double distance = 0;
    bool facing = false;  ///< a square foot within the join distance; the borders run alike
    bool forward = false; ///< b has the same direction as a
    bool end_of_b = false;

    /// True if b lies beside a on the side of greater (else lesser) t, too.
    bool goes_on(bool greater) const { return !end_of_b || s != (forward == greater ? 1 : 0); }
};

/// True if the borders face each other from one projection to the next without a turn.
bool go_on(const Look& x, const Look& y) {
    const bool ordered = x.forward ? x.s < y.s : x.s > y.s;
    return x.facing && y.facing && x.forward == y.forward && ordered;
}

/// Parameter of the foot, or that of an end of the curve if it is equally near.
double snapped(const ClosestPoint& foot) {
    const double speed = foot.point.first.length();
    if (foot.t * speed <= snap) return 0;
    if ((1 - foot.t) * speed <= snap) return 1;
    return foot.t;
}

class Alongside {
public:
    Alongside(const Border& a, const Border& b, double join)
        : a_(a),
          b_(b),
          join_(join),
          a_closed_(closed(a)),
          b_closed_(closed(b)),
          approach_(border_approach(a, b, join)) {}

    std::vector<Stretch> stretches() const {
        std::vector<Stretch> found;
        for (const ParameterInterval& range : approach_.close) {
            std::vector<Look> looks = looks_in(range);
            add_looks_between(looks);
            collect(looks, found);
        }
        for (Stretch& stretch : found) mark_overlaps(stretch);
        return found;
    }

private:
    static bool closed(const Border& border) {
        const auto& points = border.polyline.points;
        return (points.front() - points.back()).length() <= snap;
    }

    std::vector<Look> looks_in(const ParameterInterval& range) const;
    void add_looks_between(std::vector<Look>& looks) const;
    void look_where_near(const Look& x, const Look& y, std::vector<Look>& more) const;
    void look_where_apart(const Look& x, const Look& y, std::vector<Look>& more) const;
    void collect(const std::vector<Look>& looks, std::vector<Stretch>& found) const;
    void mark_overlaps(Stretch& stretch) const;

    Look look(double t, double guess) const;
    std::optional<Look> look_at_end_of_b(double s) const;
    std::optional<bool> directions(const ClosestPoint& foot, double t,
                                   const SurfaceCurve::Point& on_a, double s,
                                   const SurfaceCurve::Point& on_b) const;
    Look last_facing(Look facing, Look lost) const;

    const Border &a_, &b_;
    double join_;
    bool a_closed_, b_closed_; ///< ends where it began
    BorderApproach approach_;
};

Look Alongside::look(double t, double guess) const {
    check_stop();
    const SurfaceCurve::Point from = a_.curve.at(t);
    const ClosestPoint foot = closest_point(b_.curve, from.position, guess);
    const std::optional<bool> forward = directions(foot, t, from, foot.t, foot.point);
    return {.t = t,
            .s = snapped(foot),
            .distance = foot.distance,
            .facing = forward.has_value(),
            .forward = forward.value_or(false)};
}

/// The point of a that faces an end of b, unless a ends before.
std::optional<Look> Alongside::look_at_end_of_b(double s) const {
    const SurfaceCurve::Point from = b_.curve.at(s);
    const ClosestPoint foot =
        closest_point(a_.curve, from.position, a_.polyline.nearest(from.position));
    const std::optional<bool> forward = directions(foot, foot.t, foot.point, s, from);
    if (!forward) return std::nullopt;
    return Look{.t = snapped(foot),
                .s = s,
                .distance = foot.distance,
                .facing = true,
                .forward = *forward,
                .end_of_b = true};
}

/// Directions of a and b at a foot on one of a point of the other: true if they are the same, false
/// if opposite; nullopt if the borders do not face each other there.
std::optional<bool> Alongside::directions(const ClosestPoint& foot, double t,
                                          const SurfaceCurve::Point& on_a, double s,
                                          const SurfaceCurve::Point& on_b) const {
    if (!(foot.distance <= join_ && foot.slip <= snap)) return std::nullopt;
    return run_alike({a_.place(t, on_a.position), on_a.first},
                     {b_.place(s, on_b.position), on_b.first}, join_);
}

std::vector<Look> Alongside::looks_in(const ParameterInterval& range) const {
    std::vector<Look> looks;
    for (const double s : {0.0, 1.0})
        if (auto end = look_at_end_of_b(s))
            for (const double t : ends_at(end->t, a_closed_)) {
                end->t = t;
                if (range.begin <= t && t <= range.end) looks.push_back(*end);
            }
    const std::size_t ends = looks.size();
    for (std::size_t i = 0; i < a_.polyline.t.size(); ++i) {
        const double t = a_.polyline.t[i];
        if (t < range.begin || t > range.end) continue;
        const auto at_end = [&](const Look& end) {
            const double speed = a_.polyline.length;
            return std::abs(end.t - t) * speed <= snap;
        };
        if (std::any_of(looks.begin(), looks.begin() + static_cast<std::ptrdiff_t>(ends), at_end))
            continue;
        Look there = look(t, b_.polyline.nearest(a_.polyline.points[i]));
        for (const double s : ends_at(there.s, b_closed_)) {
            there.s = s;
            looks.push_back(there);
        }
    }
    // Of the ends of a closed b that face one point of a, that of the part before comes first.
    std::sort(looks.begin(), looks.end(), [](const Look& x, const Look& y) {
        if (x.t != y.t) return x.t < y.t;
        return x.forward ? x.s > y.s : x.s < y.s;
    });
    return looks;
}

/// Adds projections between others. If one of two neighbours does not face b, the borders may still
/// meet between them; if both do, they may part.
void Alongside::add_looks_between(std::vector<Look>& looks) const {
    std::vector<Look> more;
    for (std::size_t i = 0; i + 1 < looks.size(); ++i)
        go_on(looks[i], looks[i + 1]) ? look_where_apart(looks[i], looks[i + 1], more)
                                      : look_where_near(looks[i], looks[i + 1], more);
    looks.insert(looks.end(), more.begin(), more.end());
    std::stable_sort(looks.begin(), looks.end(),
                     [](const Look& x, const Look& y) { return x.t < y.t; });
}

void Alongside::look_where_near(const Look& x, const Look& y, std::vector<Look>& more) const {
    const std::vector<double>& nearest = approach_.nearest;
    const auto first = std::upper_bound(nearest.begin(), nearest.end(), x.t);
    for (auto t = first; t != nearest.end() && *t < y.t; ++t)
        if (t == first || *t != *(t - 1))
            more.push_back(look(*t, b_.polyline.nearest(a_.curve.at(*t).position)));
}

void Alongside::look_where_apart(const Look& x, const Look& y, std::vector<Look>& more) const {
    const CurvePolyline& b = b_.polyline;
    const double reach = join_ + a_.polyline.deviation;
    const Vec3 from = a_.curve.at(x.t).position, to = a_.curve.at(y.t).position;
    const auto [low, high] = std::minmax(x.s, y.s);
    for (auto s = std::upper_bound(b.t.begin(), b.t.end(), low); s != b.t.end() && *s < high; ++s) {
        const Vec3& point = b.points[static_cast<std::size_t>(s - b.t.begin())];
        if (segment_distance(from, to, point) <= reach) continue;
        const double share = (*s - x.s) / (y.s - x.s);
        const double t = closest_point(a_.curve, point, x.t + share * (y.t - x.t), x.t, y.t).t;
        if (x.t < t && t < y.t) more.push_back(look(t, *s));
    }
}

/// Bisects between a point that faces b and one that does not.
Look Alongside::last_facing(Look facing, Look lost) const {
    constexpr int halvings = 40;
    for (int i = 0; i < halvings; ++i) {
        const double t = (facing.t + lost.t) / 2;
        if (t == facing.t || t == lost.t) break;
        const Look middle = look(t, facing.s);
        const bool same_branch = middle.facing && middle.forward == facing.forward;
        (same_branch ? facing : lost) = middle;
    }
    return facing;
}

void Alongside::collect(const std::vector<Look>& looks, std::vector<Stretch>& found) const {
    Stretch current;
    const auto add = [&](const Look& x) {
        if (!current.points.empty() && !(x.t > current.points.back().t)) return;
        current.points.push_back({x.t, x.s, x.distance, false});
    };
    const auto close = [&] {
        if (current.points.size() > 1) found.push_back(std::move(current));
        current = {};
    };
    for (std::size_t i = 0; i + 1 < looks.size(); ++i) {
        const Look &x = looks[i], &y = looks[i + 1];
        if (go_on(x, y)) {
            add(x), add(y);
            continue;
        }
        if (x.facing && !y.facing && x.goes_on(true)) add(x), add(last_facing(x, y));
        close();
        if (!x.facing && y.facing && y.goes_on(false)) add(last_facing(y, x)), add(y);
    }
    close();
}

void Alongside::mark_overlaps(Stretch& stretch) const {
    for (FacingPoints& p : stretch.points) {
        if (p.distance <= indistinct_share * join_) continue;
        const auto a = a_.curve.frame(p.t), b = b_.curve.frame(p.s);
        if (!a || !b) continue;
        const Vec3 across = b->position - a->position;
        const double most = std::max(across.dot(a->inward), -across.dot(b->inward));
        p.overlap = most > 0.5 * p.distance;
    }
}

} // namespace

std::vector<Stretch> stretches_alongside(const Border& a, const Border& b, double join) {
    return Alongside(a, b, join).stretches();
}

} // namespace keiko
