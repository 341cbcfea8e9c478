#pragma once

#include "keiko/light/areas/area_lights.h"

#include "tests/support/oracle.h"

#include <vector>

namespace keiko::test {

/// The faces of the body of a row of area_polyhedron, as panels that shine outwards.
inline std::vector<PolygonLight> faces_of(const OracleRow& row) {
    const std::vector<Vec3> body = row.points("in.body");
    const std::vector<double> luminances = row.list("in.Lf");
    std::vector<PolygonLight> faces;
    const auto add = [&](std::vector<Vec3> corners, const Vec3& center) {
        if (polygon_normal(corners).dot(corners[0] - center) < 0)
            std::reverse(corners.begin(), corners.end());
        faces.push_back({std::move(corners), Rgb(luminances.at(faces.size()))});
    };
    if (row.text("in.kind") == "box") {
        for (std::size_t axis = 1; axis <= 3; ++axis)
            for (const double side : {-1.0, 1.0}) {
                const Vec3 middle = body[0] + body[axis] * side;
                const Vec3 &u = body[axis % 3 + 1], &v = body[(axis + 1) % 3 + 1];
                add({middle - u - v, middle + u - v, middle + u + v, middle - u + v}, body[0]);
            }
        return faces;
    }
    const Vec3 center = (body[0] + body[1] + body[2] + body[3]) / 4;
    for (std::size_t i = 0; i < 4; ++i)
        add({body[(i + 1) % 4], body[(i + 2) % 4], body[(i + 3) % 4]}, center);
    return faces;
}

} // namespace keiko::test
