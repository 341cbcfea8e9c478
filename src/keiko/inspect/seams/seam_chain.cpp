#include "keiko/inspect/seams/seam_chain.h"

#include "keiko/base/job.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/seam/border_run.h"
#include "keiko/math/disjoint_sets.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace keiko {
namespace {

using FacePair = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t, std::uint32_t>;

/// The first place of a curve, from parameter t to its end `stop`, that is `length` mm from a
/// given one; nullopt if none is. Sampled in eighths.
std::optional<Vec3> leaves(const SurfaceCurve& curve, double t, double stop, const Vec3& from,
                           double length) {
    constexpr int steps = 8, halvings = 30;
    const auto is_out = [&](double x) { return (curve.at(x).position - from).length() >= length; };
    for (int i = 1; i <= steps; ++i) {
        double out = t + (stop - t) * i / steps, in = t + (stop - t) * (i - 1) / steps;
        if (!is_out(out)) continue;
        for (int k = 0; k < halvings; ++k) (is_out((in + out) / 2) ? out : in) = (in + out) / 2;
        return curve.at(out).position;
    }
    return std::nullopt;
}

/// Direction from the place `length` mm away on a loop of borders, forward or backwards from
/// parameter t of one of its curves, to that parameter. That of the curve itself if the loop does
/// not reach so far.
Vec3 run_into(const BoundaryCurves& curves, BoundaryInterval on, double t, bool forward,
              double length) {
    const std::uint32_t first = on.curve;
    const SurfaceCurve::Point at = curves.curve(on).at(t);
    do {
        const double stop = forward ? 1 : 0;
        if (const auto out = leaves(curves.curve(on), t, stop, at.position, length))
            return at.position - *out;
        on = curves.beside(on, forward);
        t = 1 - stop;
    } while (on.curve != first);
    return forward ? -at.first : at.first;
}

/// mm: a foot that slips by more along its curve lies beyond the curve's end.
constexpr double square_foot = 1e-6;

using BorderKey = std::tuple<std::uint32_t, std::uint32_t, std::uint32_t>;

BorderKey key_of(const BoundaryInterval& on) {
    return {on.instance, on.face, on.curve};
}

/// The parts of every border that belong to seams.
class SeamCover {
public:
    explicit SeamCover(std::span<const Seam> seams) {
        for (const Seam& seam : seams) add(seam);
    }

    void add(const Seam& seam) {
        for (const BoundaryInterval* on : {&seam.a, &seam.b})
            covers_[key_of(*on)].push_back(
                {std::min(on->begin, on->end), std::max(on->begin, on->end)});
    }

    /// Parameter, greater or smaller than `t`, up to which a border is free.
    double free_until(const BoundaryInterval& on, double t, bool greater) const {
        double free = greater ? 1 : 0;
        for (const ParameterInterval& cover : covers_.at(key_of(on))) {
            const double next = greater ? cover.begin : cover.end;
            const bool ahead = greater ? next >= t && cover.end > t : next <= t && cover.begin < t;
            if (ahead) free = greater ? std::min(free, next) : std::max(free, next);
        }
        return free;
    }

private:
    std::map<BorderKey, std::vector<ParameterInterval>> covers_;
};

/// Two parameters of the borders of a seam that face each other.
struct Facing {
    double t = 0, s = 0;
};

class Widening {
public:
    Widening(const BoundaryCurves& curves, const Seam& seam, double join, const SeamCover& cover)
        : seam_(seam),
          a_(curves.curve(seam.a)),
          b_(curves.curve(seam.b)),
          join_(join),
          cover_(cover) {}

    /// Place where the borders part beyond an end of the seam; the end itself if its gap is not the
    /// reason why it ended.
    Facing parted(bool at_end) const {
        Facing last =
            at_end ? Facing{seam_.a.end, seam_.b.end} : Facing{seam_.a.begin, seam_.b.begin};
        constexpr double at_join = 0.999;
        const double gap = (a_.at(last.t).position - b_.at(last.s).position).length();
        if (gap < at_join * join_) return last;
        const bool b_greater = (seam_.b.begin < seam_.b.end) == at_end;
        const double t_limit = cover_.free_until(seam_.a, last.t, at_end);
        const double s_limit = cover_.free_until(seam_.b, last.s, b_greater);
        constexpr int steps = 64;
        const double from = last.t;
        for (int i = 1; i <= steps; ++i) {
            const double t = from + (t_limit - from) * i / steps;
            const std::optional<Facing> next = facing(t, last.s, s_limit);
            if (!next) return last_facing(last, t, s_limit);
            last = *next;
        }
        return last;
    }

private:
    /// Bisects between a place that faces the other border and one that does not.
    Facing last_facing(Facing last, double lost, double s_limit) const {
        constexpr int halvings = 40;
        for (int i = 0; i < halvings; ++i) {
            const double t = (last.t + lost) / 2;
            const std::optional<Facing> middle = facing(t, last.s, s_limit);
            if (middle)
                last = *middle;
            else
                lost = t;
        }
        return last;
    }

    std::optional<Facing> facing(double t, double guess, double s_limit) const {
        static const double sin_parallel = std::sin(parallel_borders);
        const SurfaceCurve::Point from = a_.at(t);
        const ClosestPoint foot = closest_point(b_, from.position, guess, guess, s_limit);
        if (foot.slip > square_foot || foot.distance > widest_gap * join_ ||
            !nearly_parallel(from.first, foot.point.first, sin_parallel))
            return std::nullopt;
        return Facing{t, foot.t};
    }

    const Seam& seam_;
    SurfaceCurve a_, b_;
    double join_;
    const SeamCover& cover_;
};

} // namespace

SeamEnd end_of(const SeamProbe& probe, const SeamPart& part, bool last) {
    const SeamPoint& point = last ? part.end : part.begin;
    const Vec3 out = last ? probe.run(point.t) : -probe.run(point.t);
    const bool inside = point.t != (last ? probe.end() : probe.begin());
    return {point.place, out, inside ? out : probe.run_out_of(last).value_or(out)};
}

std::array<Vec3, 2> runs_out(const BoundaryCurves& curves, const Seam& seam) {
    static const double length = same_vertex / std::sin(seam_corner);
    return {run_into(curves, seam.a, seam.a.begin, true, length),
            run_into(curves, seam.a, seam.a.end, false, length)};
}

std::array<SeamEnd, 2> ends_of(const BoundaryCurves& curves, const Seam& seam) {
    const SurfaceCurve curve = curves.curve(seam.a);
    const SurfaceCurve::Point first = curve.at(seam.a.begin), last = curve.at(seam.a.end);
    const auto [run_begin, run_end] = runs_out(curves, seam);
    return {SeamEnd{first.position, -first.first, run_begin},
            SeamEnd{last.position, last.first, run_end}};
}

bool goes_on(const SeamEnd& from, const SeamEnd& into, double reach) {
    if (is_corner(from.out, -into.out) && is_corner(from.run, -into.run)) return false;
    const Vec3 way = into.place - from.place;
    if (way.length() <= same_vertex) return true;
    return way.length() <= reach && !is_corner(from.out, way) && !is_corner(way, -into.out);
}

bool touch(const std::array<SeamEnd, 2>& a, const std::array<SeamEnd, 2>& b, double reach) {
    for (const SeamEnd& x : a)
        for (const SeamEnd& y : b)
            if (goes_on(x, y, reach)) return true;
    return false;
}

std::vector<std::vector<std::uint32_t>> seam_chains(const BoundaryCurves& curves,
                                                    std::span<const Seam> seams, double join) {
    std::vector<std::array<SeamEnd, 2>> ends;
    std::map<FacePair, std::vector<std::uint32_t>> by_faces;
    DisjointSets sets(seams.size());
    for (std::uint32_t i = 0; i < seams.size(); ++i) {
        const BoundaryInterval &a = seams[i].a, &b = seams[i].b;
        ends.push_back(ends_of(curves, seams[i]));
        auto& same = by_faces[FacePair(a.instance, a.face, b.instance, b.face)];
        for (const std::uint32_t j : same)
            if (touch(ends[i], ends[j], join)) sets.join(i, j);
        same.push_back(i);
    }
    std::map<std::size_t, std::vector<std::uint32_t>> chains;
    for (std::uint32_t i = 0; i < seams.size(); ++i) chains[sets.root(i)].push_back(i);
    std::vector<std::vector<std::uint32_t>> result;
    result.reserve(chains.size());
    for (auto& [first, pieces] : chains) result.push_back(std::move(pieces));
    return result;
}

std::vector<Seam> widened_seams(const BoundaryCurves& curves, std::span<const Seam> seams,
                                double join) {
    std::vector<Seam> result(seams.begin(), seams.end());
    SeamCover cover(result);
    for (Seam& seam : result) {
        check_stop();
        const Widening widening(curves, seam, join, cover);
        const Facing begin = widening.parted(false), end = widening.parted(true);
        seam.a.begin = begin.t, seam.a.end = end.t;
        seam.b.begin = begin.s, seam.b.end = end.s;
        cover.add(seam);
    }
    return result;
}

} // namespace keiko
