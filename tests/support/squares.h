#pragma once

#include "tests/support/shapes.h"

#include <algorithm>
#include <cmath>

namespace keiko::test {

/// Index of the edge that the squares share.
constexpr std::uint32_t squares_edge = 0;

/// Two squares that share an edge along x = 0, apart by `gap` (negative: they overlap) and the
/// second folded up by `fold` rad about the edge. The file claims `tolerance` for the edge.
inline SurfaceModel squares(double gap, double tolerance, double fold) {
    ShapeBuilder builder;
    const std::uint32_t edge = builder.edge(tolerance), rim = builder.edge(0);
    for (const double side : {-1.0, 1.0}) {
        const double inner = side * gap / 2, outer = side * 10;
        const double lift = side > 0 ? std::sin(fold) : 0, reach = side > 0 ? std::cos(fold) : 1;
        const double low = std::min(inner, outer), high = std::max(inner, outer);
        PatchData patch = rectangle(low, high, -10, 10, 0);
        for (Vec4& p : patch.points) p = Vec4(p.x * reach, p.y, p.x * lift, 1);
        LoopData border{line({outer, -10}, {outer, 10}, rim), line({outer, 10}, {inner, 10}, rim),
                        line({inner, 10}, {inner, -10}, edge),
                        line({inner, -10}, {outer, -10}, rim)};
        builder.face({patch}, {border});
    }
    return builder.model();
}

} // namespace keiko::test
