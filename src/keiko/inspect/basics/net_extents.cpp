#include "keiko/inspect/basics/net_extents.h"

#include <algorithm>

namespace keiko {

std::array<double, 2> net_extents(const BezierPatchView& patch) {
    const auto at = [&](int i, int j) { return euclidean(patch.point(i, j)); };
    std::array<double, 2> most{};
    for (int i = 0; i <= patch.degree_u; ++i)
        for (int j = 0; j <= patch.degree_v; ++j) {
            if (i > 0)
                most[0] = std::max(most[0], (at(i, j) - at(i - 1, j)).length() * patch.degree_u);
            if (j > 0)
                most[1] = std::max(most[1], (at(i, j) - at(i, j - 1)).length() * patch.degree_v);
        }
    return most;
}

} // namespace keiko
