#include "keiko/inspect/flaws/ripple_groups.h"

#include "keiko/math/disjoint_sets.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace keiko {

std::vector<std::vector<FaceRipple>> ripple_groups(const FaceAdjacency& faces,
                                                   std::vector<FaceRipple> ripples, double cell) {
    using Cell = std::array<long, 4>; // of a sheet, in space
    const auto number = [cell](double x) { return static_cast<long>(std::floor(x / cell)); };
    std::stable_sort(ripples.begin(), ripples.end(), [](const FaceRipple& a, const FaceRipple& b) {
        return std::abs(a.depth) > std::abs(b.depth);
    });
    DisjointSets sets(ripples.size());
    std::map<Cell, std::size_t> cells;
    for (std::size_t i = 0; i < ripples.size(); ++i) {
        const Vec3& p = ripples[i].position;
        const Cell at{static_cast<long>(faces.sheet(ripples[i].at.face)), number(p.x), number(p.y),
                      number(p.z)};
        cells.try_emplace(at, i);
        for (int k = 0; k < 27; ++k) {
            const auto near =
                cells.find({at[0], at[1] + k % 3 - 1, at[2] + k / 3 % 3 - 1, at[3] + k / 9 - 1});
            if (near != cells.end()) sets.join(i, near->second);
        }
    }
    std::map<std::size_t, std::size_t> group_of;
    std::vector<std::vector<FaceRipple>> groups;
    for (std::size_t i = 0; i < ripples.size(); ++i) {
        const auto [at, fresh] = group_of.try_emplace(sets.root(i), groups.size());
        if (fresh) groups.emplace_back();
        groups[at->second].push_back(ripples[i]);
    }
    return groups;
}

} // namespace keiko
