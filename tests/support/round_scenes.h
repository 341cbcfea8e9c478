#pragma once

#include "tests/support/analytic_models.h"
#include "tests/support/random.h"

#include <numbers>

namespace keiko::test {

/// One of low, low + 1 ... high, times ten.
inline double round_number(Random& random, int low, int high) {
    return 10.0 * (low + static_cast<int>(pick(random, std::size_t(high - low + 1))));
}

inline Vec3 round_place(Random& random, int low, int high) {
    const double x = round_number(random, low, high), y = round_number(random, low, high);
    return {x, y, round_number(random, low, high)};
}

inline void add_box(ModelBuilder& builder, const Vec3& low, const Vec3& size) {
    const Vec3 x(size.x, 0, 0), y(0, size.y, 0), z(0, 0, size.z);
    builder.plane(low, y, x), builder.plane(low + z, x, y);
    builder.plane(low, x, z), builder.plane(low + y, z, x);
    builder.plane(low, z, y), builder.plane(low + x, y, z);
}

/// With the origin at `center` and the axis z along y.
inline void add_turned(ModelBuilder& builder, NurbsSurface surface, const Vec3& center) {
    for (Vec4& p : surface.points)
        p = Vec4(center.x * p.w + p.x, center.y * p.w + p.z, center.z * p.w - p.y, p.w);
    builder.nurbs(surface);
}

inline NurbsSurface cylinder(double radius, double length) {
    return revolution(1, {0, 0, 1, 1}, {{radius, 0, 0, 1}, {radius, 0, length, 1}});
}

inline NurbsSurface sphere(double radius) {
    const double s = std::numbers::sqrt2 / 2, r = radius;
    return revolution(
        2, {0, 0, 0, 1, 1, 2, 2, 2},
        {{0, 0, -r, 1}, {r * s, 0, -r * s, s}, {r, 0, 0, 1}, {r * s, 0, r * s, s}, {0, 0, r, 1}});
}

/// Boxes, cylinders along y and a ball on a grid of 10 mm, up to z = 120.
inline SurfaceModel round_scene(Random& random) {
    ModelBuilder builder;
    for (int i = 0; i < 3; ++i)
        add_box(builder, round_place(random, 0, 8), round_place(random, 1, 4));
    for (int i = 0; i < 2; ++i)
        add_turned(builder, cylinder(round_number(random, 1, 2), round_number(random, 1, 5)),
                   round_place(random, 0, 9));
    add_turned(builder, sphere(round_number(random, 1, 3)), round_place(random, 0, 9));
    return builder.build();
}

} // namespace keiko::test
