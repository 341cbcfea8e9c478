#pragma once

#include "tests/support/model_builder.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace keiko::test {

/// A profile of homogeneous points (w r, 0, w z, w) turned about z in rational quadratic arcs: an
/// exact surface of revolution, its normals (du x dv) outwards where the profile runs upwards.
inline NurbsSurface revolution(int degree, const std::vector<double>& knots,
                               const std::vector<Vec4>& profile) {
    const double s = std::numbers::sqrt2 / 2;
    const Vec3 circle[9] = {{1, 0, 1},   {s, s, s},  {0, 1, 1},  {-s, s, s}, {-1, 0, 1},
                            {-s, -s, s}, {0, -1, 1}, {s, -s, s}, {1, 0, 1}};
    NurbsSurface surface{2, degree, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, knots, {}};
    for (const Vec3& c : circle)
        for (const Vec4& p : profile)
            surface.points.emplace_back(p.x * c.x, p.x * c.y, p.z * c.z, p.w * c.z);
    return surface;
}

/// The unit sphere about the origin, placed by `transform`; exact, one face of 8 patches.
inline SurfaceModel sphere_model(const Affine& transform) {
    const double s = std::numbers::sqrt2 / 2;
    ModelBuilder builder;
    builder.nurbs(
        revolution(2, {0, 0, 0, 1, 1, 2, 2, 2},
                   {{0, 0, -1, 1}, {s, 0, -s, s}, {1, 0, 0, 1}, {s, 0, s, s}, {0, 0, 1, 1}}));
    builder.instance(transform);
    return builder.build();
}

/// The mantle of the cylinder x^2 + y^2 = 1, |z| <= 1, placed by `transform`; one face.
inline SurfaceModel cylinder_model(const Affine& transform) {
    ModelBuilder builder;
    builder.nurbs(revolution(1, {0, 0, 1, 1}, {{1, 0, -1, 1}, {1, 0, 1, 1}}));
    builder.instance(transform);
    return builder.build();
}

/// A torus about z through the radii of its middle circle and of its tube, mm; one face of 16
/// patches, whose borders lie `turned` radians about the tube from where it is widest.
inline SurfaceModel torus_model(double radius, double tube, double turned = 0) {
    std::vector<Vec4> profile;
    for (int i = 0; i <= 8; ++i) {
        const double angle = turned + i * std::numbers::pi / 4, w = i % 2 ? std::sqrt(0.5) : 1,
                     reach = tube / w;
        profile.emplace_back(w * (radius + reach * std::cos(angle)), 0, w * reach * std::sin(angle),
                             w);
    }
    ModelBuilder builder;
    builder.nurbs(revolution(2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, profile));
    return builder.build();
}

/// Stretches the axes by the radii, then turns z into `axis`, then moves the origin.
inline Affine stretched(const Vec3& radii, const Vec3& axis, const Vec3& center) {
    const Vec3 z = axis.normalized();
    const Vec3 beside = std::abs(z.y) < 0.9 ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    const Vec3 x = beside.cross(z).normalized();
    const Vec3 y = z.cross(x);
    Affine map;
    map.rows = {Vec3(x.x * radii.x, y.x * radii.y, z.x * radii.z),
                Vec3(x.y * radii.x, y.y * radii.y, z.y * radii.z),
                Vec3(x.z * radii.x, y.z * radii.y, z.z * radii.z)};
    map.translation = center;
    return map;
}

/// A bonnet: a bicubic sheet over [0, length] x [-width/2, width/2], crowned by `crown` each way,
/// all mm, its middle up, front edge at x = 0.
inline SurfaceModel bonnet_model(double length, double width, double crown) {
    ModelBuilder builder;
    std::vector<Vec3> points;
    for (int i = 0; i <= 3; ++i)
        for (int j = 0; j <= 3; ++j) {
            const double bulge_u = i == 1 || i == 2 ? 1 : 0, bulge_v = j == 1 || j == 2 ? 1 : 0;
            points.emplace_back(length * i / 3, width * (j / 3.0 - 0.5),
                                4.0 / 3 * crown * (bulge_u + bulge_v));
        }
    builder.patch(3, 3, points);
    return builder.build();
}

} // namespace keiko::test
