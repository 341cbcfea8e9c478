#pragma once

#include "tests/support/model_builder.h"

#include <vector>

namespace keiko::test {

/// A bulging sheet of 300 x 200 mm without any symmetry.
inline SurfaceModel uneven_sheet() {
    std::vector<Vec3> points;
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j)
            points.emplace_back(100 * i, 200.0 / 3 * j, 9 * i + 20 * (i % 3 != 0) + 7 * j * j);
    points[5].z += 11;
    ModelBuilder builder;
    builder.patch(3, 3, points);
    return builder.build();
}

} // namespace keiko::test
