#include "keiko/inspect/basics/boundary_factors.h"

#include <algorithm>

namespace keiko {

std::vector<BoundaryFactor> divide_sides(BernsteinField& field, double tolerance) {
    std::vector<BoundaryFactor> sides;
    for (const bool by_u : {true, false})
        for (const bool upper : {false, true}) {
            int times = 0;
            while ((by_u ? field.degree_u() : field.degree_v()) > 0 &&
                   field.side_range(by_u, upper).magnitude() <=
                       std::max(tolerance, 2 * field.rounding())) {
                field = field.without_side(by_u, upper);
                ++times;
            }
            if (times > 0) sides.push_back({by_u, upper, times});
        }
    return sides;
}

} // namespace keiko
