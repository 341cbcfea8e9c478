#include "keiko/base/error.h"
#include "keiko/import/cad/curve_spans.h"
#include "keiko/import/cad/trim_chains.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace keiko::cad {
namespace {

/// Number of times, with sign, that a chain runs around the surface along an axis.
int turns(const Chain& chain, const ParameterSpace& space, unsigned axis) {
    const double wrap = space.wrap[axis];
    if (!(wrap > 0)) return 0;
    const double way = end_of(chain)[axis] - begin_of(chain)[axis];
    const double count = std::round(way / wrap);
    return std::abs(way - count * wrap) < 0.05 * wrap ? static_cast<int>(count) : 0;
}

double lower_end(const Chain& chain, unsigned axis) {
    return std::min(begin_of(chain)[axis], end_of(chain)[axis]);
}

Vec2 along(unsigned axis, double length) {
    return axis == 0 ? Vec2(length, 0) : Vec2(0, length);
}

double coordinate(const LoopCurve& curve, double t, unsigned axis) {
    return evaluate(BezierCurveView{curve.points}, t, 0)[0][axis];
}

/// Parameter at which a piece that spans `target` along the axis reaches it.
double crossing(const LoopCurve& curve, double target, unsigned axis) {
    double low = 0, high = 1;
    const bool rising = coordinate(curve, 1, axis) > coordinate(curve, 0, axis);
    while (high - low > 1e-15) {
        const double middle = (low + high) / 2;
        if (middle == low || middle == high) break;
        (((coordinate(curve, middle, axis) < target) == rising) ? low : high) = middle;
    }
    return (low + high) / 2;
}

/// Cuts a chain that runs once around at `target` and puts its parts in the other order, so that
/// it begins or ends there.
Chain cut_around(const Chain& chain, double target, const ParameterSpace& space, unsigned axis) {
    const bool rising = end_of(chain)[axis] > begin_of(chain)[axis];
    Chain before, after;
    for (const LoopCurve& curve : chain) {
        const double from = coordinate(curve, 0, axis), to = coordinate(curve, 1, axis);
        if (!after.empty() || (from > target) == rising) {
            after.push_back(curve);
        } else if ((to > target) != rising || to == target) {
            before.push_back(curve);
        } else {
            const double t = crossing(curve, target, axis);
            before.push_back({bezier_segment(curve.points, 0, t), curve.edge});
            after.push_back({bezier_segment(curve.points, t, 1), curve.edge});
        }
    }
    shift(rising ? after : before, along(axis, -space.wrap[axis]));
    after.insert(after.end(), before.begin(), before.end());
    return after;
}

/// Moves a chain that runs once around into the window that begins at `low`.
void move_to_window(Chain& chain, double low, const ParameterSpace& space, unsigned axis) {
    const double period = space.period[axis], wrap = space.wrap[axis];
    const double slack = small_gap * wrap;
    if (period > 0)
        shift(chain,
              along(axis, -std::floor((lower_end(chain, axis) - low + slack) / period) * period));
    if (lower_end(chain, axis) - low > slack) chain = cut_around(chain, low + wrap, space, axis);
}

/// Closes a chain by straight connectors over the line where the other coordinate is `far`.
Chain closed_over(Chain chain, double far, unsigned axis) {
    const Vec2 begin = begin_of(chain), end = end_of(chain);
    Vec2 end_corner = end, begin_corner = begin;
    end_corner[1 - axis] = begin_corner[1 - axis] = far;
    if (end_corner != end) chain.push_back(connector(end, end_corner));
    chain.push_back(connector(end_corner, begin_corner));
    if (begin_corner != begin) chain.push_back(connector(begin_corner, begin));
    return chain;
}

/// The band between two chains that run once around, as one loop.
Chain band(Chain a, Chain b, const ParameterSpace& space, unsigned axis, RepairLog& log) {
    if (turns(a, space, axis) == turns(b, space, axis)) {
        reverse(b);
        log.add(RepairKind::wire_reversed);
    }
    const unsigned other = 1 - axis;
    // Material is on the left, so along u the rising chain is the lower border; along v the upper.
    Chain& lower = (turns(a, space, axis) > 0) == (axis == 0) ? a : b;
    Chain& upper = &lower == &a ? b : a;
    const double below = tight_bounds(lower).center()[other] - tight_bounds(upper).center()[other];
    const double period = space.period[other];
    if (period > 0 && below > 0) shift(upper, along(other, std::ceil(below / period) * period));
    a.push_back(connector(end_of(a), begin_of(b)));
    b.push_back(connector(end_of(b), begin_of(a)));
    a.insert(a.end(), b.begin(), b.end());
    return a;
}

/// The side of the surface that a lone chain around it has on its left.
double far_side(const Chain& chain, const ParameterSpace& space, unsigned axis) {
    const bool upper = (turns(chain, space, axis) > 0) == (axis == 0);
    double far = (upper ? space.natural.upper : space.natural.lower)[1 - axis];
    if (!std::isfinite(far) && axis == 0) far = space.apex_v;
    if (!std::isfinite(far))
        throw Error("", "", "a wire around an infinite surface bounds it on one side only");
    return far;
}

/// Loops of the chains that run around along `axis`.
std::vector<Chain> close_around(std::vector<Chain> around, const ParameterSpace& space,
                                unsigned axis, RepairLog& log) {
    if (around.empty()) return {};
    for (std::size_t i = 0; i < around.size(); ++i) log.add(RepairKind::wire_around_closed);
    const double low = lower_end(around.front(), axis);
    for (Chain& chain : around) move_to_window(chain, low, space, axis);
    if (around.size() == 2)
        return {band(std::move(around[0]), std::move(around[1]), space, axis, log)};
    double far = around.size() == 1 ? far_side(around.front(), space, axis) : Box2::infinity;
    if (around.size() > 1)
        for (const Chain& chain : around) far = std::min(far, tight_bounds(chain).lower[1 - axis]);
    std::vector<Chain> loops;
    loops.reserve(around.size());
    for (Chain& chain : around) loops.push_back(closed_over(std::move(chain), far, axis));
    return loops;
}

Chain closed_directly(Chain chain, const ParameterSpace& space, RepairLog& log) {
    const Vec2 end = end_of(chain), begin = begin_of(chain);
    if (space.relative(begin - end) > small_gap) {
        log.add(RepairKind::loop_closed, space.distance(end, begin));
        chain.push_back(connector(end, begin));
    }
    return chain;
}

/// Copies of a loop that crosses the border of a box one period wide, and itself.
std::vector<Chain> placed_in(const Box2& box, Chain loop, const ParameterSpace& space,
                             bool& crosses) {
    std::vector<Chain> copies{std::move(loop)};
    for (unsigned axis = 0; axis < 2; ++axis) {
        const double period = space.period[axis];
        if (!(period > 0)) continue;
        const double slack = small_gap * period;
        const bool whole = box.extent()[axis] > period - slack;
        std::vector<Chain> shifted;
        for (Chain& copy : copies) {
            const Box2 own = tight_bounds(copy);
            shift(copy,
                  along(axis, std::round((box.center() - own.center())[axis] / period) * period));
            const Box2 moved = tight_bounds(copy);
            const double sign = moved.lower[axis] < box.lower[axis] - slack   ? 1
                                : moved.upper[axis] > box.upper[axis] + slack ? -1
                                                                              : 0;
            if (!whole || sign == 0) continue;
            crosses = true;
            shifted.push_back(copy);
            shift(shifted.back(), along(axis, sign * period));
        }
        std::move(shifted.begin(), shifted.end(), std::back_inserter(copies));
    }
    return copies;
}

/// Moves all loops to where the largest lies.
ClosedLoops gathered(std::vector<Chain> loops, const ParameterSpace& space, RepairLog& log) {
    const auto area = [](const Chain& loop) {
        const Vec2 extent = tight_bounds(loop).extent();
        return extent.x * extent.y;
    };
    const auto largest =
        std::max_element(loops.begin(), loops.end(),
                         [&](const Chain& a, const Chain& b) { return area(a) < area(b); });
    const Box2 box = tight_bounds(*largest);
    ClosedLoops result;
    bool crosses = false;
    for (auto loop = loops.begin(); loop != loops.end(); ++loop) {
        auto copies =
            loop == largest ? std::vector<Chain>{*loop} : placed_in(box, *loop, space, crosses);
        for (Chain& copy : copies) {
            result.domain.extend(tight_bounds(copy));
            result.loops.push_back(std::move(copy));
        }
    }
    if (crosses) {
        result.domain = box;
        log.add(RepairKind::loop_doubled);
    }
    return result;
}

/// How far, in mm, the loops go beyond the surface's domain: of the ends and middles of their
/// curves the farthest.
double way_out(const std::vector<Chain>& loops, const ParameterSpace& space) {
    double worst = 0;
    for (const Chain& loop : loops)
        for (const LoopCurve& curve : loop)
            for (const double t : {0.0, 0.5}) {
                const Vec2 at = evaluate(BezierCurveView{curve.points}, t, 0)[0];
                Vec2 inside = at;
                for (unsigned axis = 0; axis < 2; ++axis)
                    if (!(space.period[axis] > 0))
                        inside[axis] = std::clamp(at[axis], space.natural.lower[axis],
                                                  space.natural.upper[axis]);
                if (inside != at) worst = std::max(worst, space.distance(inside, at));
            }
    return worst;
}

/// A box that goes only a little beyond the surface's domain; the way beyond it is logged.
Box2 near_natural(Box2 box, const std::vector<Chain>& loops, const ParameterSpace& space,
                  RepairLog& log) {
    double outside = 0;
    for (unsigned axis = 0; axis < 2; ++axis) {
        if (space.period[axis] > 0) continue;
        const double lower = space.natural.lower[axis], upper = space.natural.upper[axis];
        const double scale = space.scale[axis];
        outside = std::max(
            {outside, (lower - box.lower[axis]) / scale, (box.upper[axis] - upper) / scale});
        if (outside <= space.continuation) continue;
        box.lower[axis] = std::max(box.lower[axis], lower);
        box.upper[axis] = std::min(box.upper[axis], upper);
    }
    if (outside > small_gap)
        log.add(outside <= space.continuation ? RepairKind::surface_continued
                                              : RepairKind::loops_cut_off,
                way_out(loops, space));
    return box;
}

} // namespace

ClosedLoops close_loops(std::vector<Chain> chains, const ParameterSpace& space, RepairLog& log) {
    std::vector<Chain> loops;
    std::vector<Chain> around[2];
    for (Chain& chain : chains) {
        const int u = turns(chain, space, 0), v = turns(chain, space, 1);
        if (u != 0)
            around[0].push_back(std::move(chain));
        else if (v != 0)
            around[1].push_back(std::move(chain));
        else
            loops.push_back(closed_directly(std::move(chain), space, log));
    }
    for (unsigned axis = 0; axis < 2; ++axis)
        for (Chain& loop : close_around(std::move(around[axis]), space, axis, log))
            loops.push_back(std::move(loop));
    if (loops.empty()) return {{}, space.natural};
    ClosedLoops result = gathered(std::move(loops), space, log);
    result.domain = near_natural(result.domain, result.loops, space, log);
    return result;
}

} // namespace keiko::cad
