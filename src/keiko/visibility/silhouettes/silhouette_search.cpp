#include "keiko/visibility/silhouettes/silhouette_search.h"

#include "keiko/visibility/nets/gradient_bounds.h"
#include "keiko/visibility/nets/linearized_system.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace keiko {

SilhouetteSearch::Result SilhouetteSearch::run(const Solve& solve, const Spread& spread,
                                               int most_boxes) const {
    constexpr double sharpest = 1e-11; ///< of the segment: closer events are one
    Result result;
    struct Open {
        Box2 box;
        ScalarNet f, g;
    };
    std::vector<Open> open{{unit_square, f_, g_}};
    for (int count = 0; !open.empty(); ++count) {
        const auto [box, f, g] = std::move(open.back());
        open.pop_back();
        if (!may_vanish(f) || !may_vanish(g, error_)) continue;
        const Vec2 size = box.extent();
        const double widest = std::max(size.x, size.y);
        GradientBounds a = slopes_of(f), b = slopes_of(g);
        b.add_error(error_, size);
        const LinearizedSystem pair(a.all, b.all);
        if (pair.root_is_outside()) continue;
        if (pair.variation() < LinearizedSystem::proved) {
            const auto found = solve(box.center() + size * 0.5 * pair.nearest_inside(), size);
            if (found && box.padded(LinearizedSystem::overlap * widest).contains(*found)) {
                result.roots.push_back(*found);
                continue;
            }
            if (found && pair.variation() < LinearizedSystem::straight) continue;
        }
        const bool sharp = spread(box) <= sharpest;
        if (sharp || count >= most_boxes) {
            result.unclear.push_back(box.center());
            result.certain = result.certain && sharp;
            continue;
        }
        Box2 low = box, high = box;
        const unsigned axis = GradientBounds{b.all, a.bend + b.bend}.axis_to_halve(size);
        low.upper[axis] = high.lower[axis] = box.center()[axis];
        auto [low_f, high_f] = halved(f, axis);
        auto [low_g, high_g] = halved(g, axis);
        open.push_back({high, std::move(high_f), std::move(high_g)});
        open.push_back({low, std::move(low_f), std::move(low_g)});
    }
    return result;
}

} // namespace keiko
