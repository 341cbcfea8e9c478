#include "keiko/raster/light_cone.h"

#include "keiko/raster/mesh_shadows.h"

#include "tests/support/sphere_and_plate.h"
#include "tests/support/sphere_points.h"
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace keiko {
namespace {

using test::add_plate, test::camera_above, test::points_of, test::sphere_and_plate;

TEST(LightCone, AgreesWithManyPointsOfTheSphere) {
    const SurfaceMesh mesh = sphere_and_plate(20);
    const ShadowCasters casters(mesh);
    Camera camera = camera_above();
    camera.width = 50, camera.height = 40;
    const MeshView view(mesh, camera);
    const LightSphere sphere{Vec3(-90, 30, 160), 25};
    const Image cones = lit_by_cones(view, casters, sphere);
    const Image points = lit_pixels(view, casters, points_of(sphere, 600), MeshShadows::ray);
    double sum = 0;
    int partly = 0;
    for (std::size_t i = 0; i < cones.values.size(); ++i) {
        const double off = double{cones.values[i]} - double{points.values[i]};
        if (points.values[i] > 0 && points.values[i] < 1) ++partly, sum += off * off;
        EXPECT_LT(std::abs(off), 0.05) << i;
    }
    EXPECT_GT(partly, 80);
    EXPECT_LT(std::sqrt(sum / partly), 0.012);
}

TEST(LightCone, HasTheShareOfADiscBesideAStraightEdge) {
    // Far below a wide plate whose edge passes the axis at a part of the sphere's image: a segment
    // of a disc. The sphere is so far that its image is small, and weighs the same everywhere.
    SurfaceMesh mesh;
    add_plate(mesh, Vec2(-1, -1), Vec2(1, 1), 0);
    const double far = 10000, half = far / 2;
    const LightSphere sphere{Vec3(0, 0, far), 100};
    for (const double part : {-0.9, -0.3, 0.0, 0.5, 0.8}) {
        SurfaceMesh with_edge = mesh;
        const double edge = part * sphere.radius / far * half;
        add_plate(with_edge, Vec2(edge, -500), Vec2(900, 500), half);
        Camera camera = test::camera_on_x(10, 9, 9);
        camera.eye = Vec3(0, 0, 10), camera.vertical_fov = 0.5;
        const MeshView view(with_edge, camera);
        const Image lit = lit_by_cones(view, ShadowCasters(with_edge), sphere, {}, 64);
        const double visible =
            1 - (std::acos(part) - part * std::sqrt(1 - part * part)) / std::numbers::pi;
        EXPECT_NEAR(*lit.pixel(4, 4), visible, 1e-3) << part;
    }
}

TEST(LightCone, IsFreeOfAPlateAroundTheEquator) {
    // Beyond the circle in which it touches the sphere the cone is wider than the sphere.
    SurfaceMesh mesh;
    add_plate(mesh, Vec2(-1, -1), Vec2(1, 1), 0);
    const LightSphere sphere{Vec3(0, 0, 60), 30};
    const double hole = sphere.radius, wide = 10 * hole;
    add_plate(mesh, Vec2(-wide, hole), Vec2(wide, wide), 60);
    add_plate(mesh, Vec2(-wide, -wide), Vec2(wide, -hole), 60);
    add_plate(mesh, Vec2(hole, -hole), Vec2(wide, hole), 60);
    add_plate(mesh, Vec2(-wide, -hole), Vec2(-hole, hole), 60);
    Camera camera = test::camera_on_x(10, 9, 9);
    camera.eye = Vec3(0, 0, 10), camera.vertical_fov = 0.5;
    const MeshView view(mesh, camera);
    EXPECT_EQ(*lit_by_cones(view, ShadowCasters(mesh), sphere).pixel(4, 4), 1);
}

} // namespace
} // namespace keiko
