#pragma once

#include "tests/support/analytic_models.h"
#include "tests/support/model_builder.h"
#include "tests/support/oracle.h"

namespace keiko::test {

/// The occluders of a row of the oracle tables visible_intervals and lamp_occluded: exact spheres,
/// planar quadrangles and bicubic patches, a face each.
inline SurfaceModel occluders_of(const OracleRow& row) {
    ModelBuilder builder;
    const double s = std::numbers::sqrt2 / 2;
    const std::vector<Vec4> half_circle{
        {0, 0, -1, 1}, {s, 0, -s, s}, {1, 0, 0, 1}, {s, 0, s, s}, {0, 0, 1, 1}};
    const std::vector<double> spheres = row.list("in.spheres");
    for (std::size_t i = 0; i + 3 < spheres.size(); i += 4) {
        NurbsSurface sphere = revolution(2, {0, 0, 0, 1, 1, 2, 2, 2}, half_circle);
        const Vec3 center(spheres[i], spheres[i + 1], spheres[i + 2]);
        for (Vec4& p : sphere.points) {
            const Vec3 q = Vec3(p.x, p.y, p.z) * spheres[i + 3] + center * p.w;
            p = {q.x, q.y, q.z, p.w};
        }
        builder.nurbs(sphere);
    }
    const std::vector<Vec3> quads = row.points("in.quads");
    for (std::size_t i = 0; i + 3 < quads.size(); i += 4)
        builder.patch(1, 1, {quads[i], quads[i + 3], quads[i + 1], quads[i + 2]});
    const std::vector<Vec3> beziers = row.points("in.bezier");
    for (std::size_t i = 0; i + 15 < beziers.size(); i += 16)
        builder.patch(3, 3,
                      {beziers.begin() + static_cast<std::ptrdiff_t>(i),
                       beziers.begin() + static_cast<std::ptrdiff_t>(i + 16)});
    return builder.build();
}

} // namespace keiko::test
