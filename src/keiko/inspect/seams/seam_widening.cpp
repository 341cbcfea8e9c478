#include "keiko/inspect/seams/seam_widening.h"

#include "keiko/base/job.h"
#include "keiko/geometry/model/closest_point.h"
#include "keiko/geometry/seam/border_approach.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

namespace keiko {
namespace {

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
