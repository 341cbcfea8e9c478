#include "keiko/trace/silhouette_search.h"

#include "keiko/trace/linear_pair.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {
namespace {

/// Of the searched box: what is so near the apex is the apex itself.
constexpr double around_apex = 1e-7;
/// A function's mean slopes over a box, in its [-1, 1]^2, how much they vary, and how much the
/// slope along each axis does, as a share of the slopes.
struct Slopes {
    AffineNet::Weighed all;
    Vec2 bend;
};

Slopes slopes_of(const ScalarNet& net) {
    const auto place = [](std::size_t i, std::size_t count) {
        return count < 2 ? 0 : 2 * static_cast<double>(i) / static_cast<double>(count - 1) - 1;
    };
    const NetRange x = derivative_range(net, true), y = derivative_range(net, false);
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t i = 0; i < net.rows; ++i)
        for (std::size_t j = 0; j < net.columns; ++j) {
            const double rest =
                net.at(i, j) - x.middle * place(i, net.rows) - y.middle * place(j, net.columns);
            low = std::min(low, rest);
            high = std::max(high, rest);
        }
    const double size = std::abs(x.middle) + std::abs(y.middle);
    return {{(low + high) / 2, x.middle, y.middle, (high - low) / 2, x.half + y.half},
            Vec2(x.half, y.half) / std::max(size, x.half + y.half)};
}

bool may_vanish(const ScalarNet& net, double error) {
    const auto [low, high] = std::minmax_element(net.c.begin(), net.c.end());
    const double slack = error + 1e-14 * std::max(std::abs(*low), std::abs(*high));
    return *low <= slack && *high >= -slack;
}

struct Interval {
    double low, high;
};

Interval operator*(const NetRange& a, const Interval& b) {
    const double p[4] = {a.low() * b.low, a.low() * b.high, a.high() * b.low, a.high() * b.high};
    return {*std::min_element(p, p + 4), *std::max_element(p, p + 4)};
}

Interval product(const NetRange& a, const NetRange& b) {
    return a * Interval{b.low(), b.high()};
}

Interval square(const NetRange& a) {
    const double low = a.low() * a.low(), high = a.high() * a.high();
    return {a.holds_zero() ? 0 : std::min(low, high), std::max(low, high)};
}

/// Bound of a polynomial's slope on [-1, 1] for values up to 1: its degree squared; the higher one
/// that the true g may have.
constexpr double steepest = (3.0 * max_occluder_degree - 1) * (3.0 * max_occluder_degree - 1);

/// The parts of a box beside an inner one.
void add_ring(const Box2& outer, const Box2& inner, std::vector<Box2>& boxes) {
    const double x[4] = {outer.lower.x, inner.lower.x, inner.upper.x, outer.upper.x};
    const double y[4] = {outer.lower.y, inner.lower.y, inner.upper.y, outer.upper.y};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            if ((i != 1 || j != 1) && x[i] < x[i + 1] && y[j] < y[j + 1])
                boxes.push_back({Vec2(x[i], y[j]), Vec2(x[i + 1], y[j + 1])});
}

} // namespace

bool is_convex(const ScalarNet& g) {
    if (g.rows < 3 || g.columns < 3) return false;
    const ScalarNet gx = derivative(g, true);
    const NetRange xx = derivative_range(gx, true), xy = derivative_range(gx, false),
                   yy = derivative_range(derivative(g, false), false);
    if (xx.holds_zero() || yy.holds_zero() || (xx.middle > 0) != (yy.middle > 0)) return false;
    const double least = (std::abs(xx.middle) - xx.half) * (std::abs(yy.middle) - yy.half);
    return least > xy.largest() * xy.largest();
}

/// By Taylor's theorem g has no other root on a section f = 0 through the apex where its second
/// derivative keeps its sign along every chord that the section may have.
bool SilhouetteSearch::bends_one_way(const ScalarNet& f, const ScalarNet& g) const {
    const NetRange fx = derivative_range(f, true), fy = derivative_range(f, false);
    if (fx.holds_zero() && fy.holds_zero()) return false;
    const ScalarNet gx = derivative(g, true), gy = derivative(g, false);
    const Interval xx = derivative_range(gx, true) * square(fy);
    const NetRange mixed = derivative_range(gx, false);
    const Interval xy = NetRange{-2 * mixed.middle, 2 * mixed.half} * product(fx, fy);
    const Interval yy = derivative_range(gy, false) * square(fx);
    const double low = xx.low + xy.low + yy.low, high = xx.high + xy.high + yy.high;
    return low > 0 || high < 0;
}

SilhouetteSearch::Result SilhouetteSearch::run(const Solve& solve, const Spread& spread,
                                               int most_boxes) const {
    constexpr double sharpest = 1e-11; ///< of the segment: closer events are one
    Result result;
    std::vector<Box2> open{unit_square};
    for (int count = 0; !open.empty(); ++count) {
        const Box2 box = open.back();
        open.pop_back();
        const bool whole = box == unit_square;
        const ScalarNet f = whole ? f_ : restricted(f_, box);
        if (!may_vanish(f, 0)) continue;
        const ScalarNet g = whole ? g_ : restricted(g_, box);
        if (!may_vanish(g, error_)) continue;
        const Vec2 size = box.extent();
        const double widest = std::max(size.x, size.y);
        if (foot_ && box.contains(*foot_)) {
            if (widest <= around_apex || bends_one_way(f, g)) continue;
            constexpr double shrink = 0.2;
            const Vec2 half = size * (shrink / 2);
            const Box2 inner = box.intersection({*foot_ - half, *foot_ + half});
            open.push_back(inner);
            add_ring(box, inner, open);
            continue;
        }
        Slopes a = slopes_of(f), b = slopes_of(g);
        // By Markov's inequality on the searched box: derivatives of what g is off by.
        b.all.off += error_;
        b.all.slope += 2 * steepest * error_ * std::max(size.x, size.y);
        const LinearPair pair(a.all, b.all);
        if (pair.root_is_outside()) continue;
        if (pair.variation() < LinearPair::proved) {
            const auto found = solve(box.center() + size * 0.5 * pair.nearest_inside(), size);
            if (found && box.padded(LinearPair::overlap * widest).contains(*found)) {
                result.roots.push_back(*found);
                continue;
            }
            if (found && pair.variation() < LinearPair::straight) continue;
        }
        const bool sharp = spread(box) <= sharpest;
        if (sharp || count >= most_boxes) {
            result.unclear.push_back(box.center());
            result.certain = result.certain && sharp;
            continue;
        }
        Box2 low = box, high = box;
        // Along a strip it takes many halvings where across it none helps.
        constexpr double slimmest = 1.0 / 256;
        const Vec2 bend = a.bend + b.bend;
        const unsigned axis = size.x < slimmest * size.y   ? 1
                              : size.y < slimmest * size.x ? 0
                              : bend.x >= bend.y           ? 0
                                                           : 1;
        low.upper[axis] = high.lower[axis] = box.center()[axis];
        open.push_back(high);
        open.push_back(low);
    }
    return result;
}

} // namespace keiko
