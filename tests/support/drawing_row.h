#pragma once

#include "tests/support/drawn_body.h"
#include "tests/support/model_builder.h"
#include "tests/support/oracle.h"

#include <vector>

namespace keiko::test {

/// The camera of a row of the tables of line drawings.
inline Camera camera_of(const OracleRow& row) {
    const bool parallel = row.text("in.proj") == "parallel";
    return camera_along(parallel ? Projection::orthographic : Projection::perspective,
                        row.vector("in.E"), row.unit("in.F"), row.unit("in.Up"));
}

/// The boxes of such a row, faces outwards, as one body.
inline SurfaceModel boxes_of(const OracleRow& row) {
    const std::vector<Vec3> values = row.points("in.boxes");
    ModelBuilder builder;
    for (std::size_t box = 0; box + 3 < values.size(); box += 4)
        for (std::size_t axis = 0; axis < 3; ++axis)
            for (const double side : {1.0, -1.0}) {
                const Vec3 middle = values[box] + values[box + 1 + axis] * side;
                const Vec3 u = values[box + 1 + (axis + 1) % 3] * side;
                const Vec3 v = values[box + 1 + (axis + 2) % 3];
                builder.plane(middle - u - v, u * 2, v * 2);
            }
    return builder.build();
}

} // namespace keiko::test
