#pragma once

#include "tests/support/model_builder.h"

#include <vector>

namespace keiko::test {

/// A bulging sheet of 300 x 200 mm without any symmetry; of it a strip along u between two shares
/// of its width.
inline SurfaceModel uneven_sheet(double from = 0, double to = 1) {
    std::vector<Vec3> points;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            points.emplace_back(100 * i, 200.0 / 3 * j, 9 * i + 20 * (i % 3 != 0) + 7 * j * j);
    points[5].z += 11;
    ModelBuilder builder;
    builder.patch(3, 3, points);
    if (from > 0 || to < 1) builder.polygon({{0, from}, {1, from}, {1, to}, {0, to}});
    return builder.build();
}

} // namespace keiko::test
