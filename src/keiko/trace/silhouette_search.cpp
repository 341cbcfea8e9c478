#include "keiko/trace/silhouette_search.h"

#include "keiko/trace/linear_pair.h"
#include "keiko/trace/slopes.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {

bool is_convex(const ScalarNet& g) {
    if (g.rows < 3 || g.columns < 3) return false;
    const ScalarNet gx = derivative(g, true);
    const NetRange xx = derivative_range(gx, true), xy = derivative_range(gx, false),
                   yy = derivative_range(derivative(g, false), false);
    if (xx.holds_zero() || yy.holds_zero() || (xx.middle > 0) != (yy.middle > 0)) return false;
    const double least = (std::abs(xx.middle) - xx.half) * (std::abs(yy.middle) - yy.half);
    return least > xy.largest() * xy.largest();
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
        if (!may_vanish(f)) continue;
        const ScalarNet g = whole ? g_ : restricted(g_, box);
        if (!may_vanish(g, error_)) continue;
        const Vec2 size = box.extent();
        const double widest = std::max(size.x, size.y);
        Slopes a = slopes_of(f), b = slopes_of(g);
        b.add_error(error_, size);
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
        const unsigned axis = Slopes{b.all, a.bend + b.bend}.axis_to_halve(size);
        low.upper[axis] = high.lower[axis] = box.center()[axis];
        open.push_back(high);
        open.push_back(low);
    }
    return result;
}

} // namespace keiko
