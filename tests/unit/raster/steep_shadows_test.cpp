#include "keiko/raster/mesh_shadows.h"

#include "tests/support/mesh_light.h"
#include "tests/support/sphere_and_plate.h"
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

namespace keiko {
namespace {

using test::wrong_beyond_rounding;

/// Algorithms without errors of their own.
constexpr std::array exact_algorithms{MeshShadows::scan_line, MeshShadows::polygons,
                                      MeshShadows::volumes};

/// Random places within a cube about the origin; seeded.
class RandomPlaces {
public:
    explicit RandomPlaces(unsigned seed) : random_(seed) {}
    double number(double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random_);
    }
    Vec3 place(double half) {
        const double x = number(-half, half), y = number(-half, half);
        return {x, y, number(-half, half)};
    }

private:
    std::mt19937 random_;
};

Camera rolled_camera(const Vec3& eye, const Vec3& up) {
    Camera camera = test::camera_above();
    camera.eye = eye, camera.target = Vec3(0), camera.up = up;
    return camera;
}

int lit_count(const Image& image) {
    int count = 0;
    for (const float share : image.values) count += share > 0 ? 1 : 0;
    return count;
}

/// Random triangles, some with planes that pass the eye within a tenth of a mm.
SurfaceMesh with_steep_triangles(RandomPlaces& random, const Vec3& eye) {
    SurfaceMesh mesh;
    for (int i = 0; i < 25; ++i) {
        const Vec3 a = random.place(60);
        test::add_triangle(mesh, {a, a + random.place(30), a + random.place(30)});
    }
    for (int i = 0; i < 25; ++i) {
        const Vec3 a = random.place(90), b = random.place(90);
        const Vec3 normal = (a - eye).cross(b - eye).normalized();
        const Vec3 c = eye + (a - eye) * random.number(0.5, 1.2) +
                       (b - eye) * random.number(-0.5, 0.5) + normal * random.number(-0.1, 0.1);
        test::add_triangle(mesh, {a + normal * random.number(-0.1, 0.1), b, c});
    }
    return mesh;
}

TEST(SteepShadows, AreThoseOfRaysOnFacetsSeenEdgeOn) {
    RandomPlaces random(11);
    for (int scene = 0; scene < 60; ++scene) {
        const Vec3 eye = random.place(150);
        const SurfaceMesh mesh = with_steep_triangles(random, eye);
        const ShadowCasters casters(mesh);
        const Camera camera = rolled_camera(eye, random.place(1));
        const MeshView view(mesh, camera);
        const Viewpoint light =
            scene % 2 == 0 ? Viewpoint::at(random.place(120)) : Viewpoint::towards(random.place(1));
        for (const MeshShadows by : exact_algorithms)
            EXPECT_EQ(
                wrong_beyond_rounding(view, casters, light, lit_pixels(view, casters, light, by)),
                0)
                << scene << " by " << static_cast<int>(by);
    }
}

TEST(SteepShadows, ReachTheHorizonOfAFloorAtAnEyeOnIt) {
    SurfaceMesh mesh;
    test::add_plate(mesh, Vec2(-4000), Vec2(4000), 0);
    for (int i = -20; i <= 20; ++i) // slats over it
        test::add_plate(mesh, Vec2(-4000, 5 * i - 1), Vec2(4000, 5 * i + 1), 40);
    const ShadowCasters casters(mesh);
    const Viewpoint light = Viewpoint::towards({-0.1, 0.2, 1});
    for (const double height : {5.0, 1.0, 0.3}) {
        Camera camera = rolled_camera(Vec3(3000, 30, height), Vec3(0, 0.6, 1));
        camera.target = Vec3(0, 0, height);
        const MeshView view(mesh, camera);
        const Image truth = lit_pixels(view, casters, light, MeshShadows::ray);
        EXPECT_GT(lit_count(truth), 500);
        for (const MeshShadows by : exact_algorithms)
            EXPECT_EQ(
                wrong_beyond_rounding(view, casters, light, lit_pixels(view, casters, light, by)),
                0)
                << height << " by " << static_cast<int>(by);
    }
}

TEST(SteepShadows, AreThoseOfRaysFromLampsBesideLongEdges) {
    RandomPlaces random(12);
    const Camera camera = test::camera_above();
    for (int scene = 0; scene < 60; ++scene) {
        SurfaceMesh mesh;
        test::add_plate(mesh, Vec2(-1500), Vec2(1500), test::floor_z);
        const Vec3 along = random.place(1).normalized() * 2000, middle = random.place(20);
        const Vec3 beside = random.place(300);
        test::add_triangle(mesh, {middle - along, middle + along, middle + beside});
        for (int i = 0; i < 8; ++i) {
            const Vec3 a = random.place(60);
            test::add_triangle(mesh, {a, a + random.place(30), a + random.place(30)});
        }
        const ShadowCasters casters(mesh);
        const double off = std::pow(10, random.number(-4, 1));
        const Viewpoint light =
            Viewpoint::at(middle + along * random.number(-0.02, 0.02) + random.place(off));
        const MeshView view(mesh, camera);
        for (const MeshShadows by : exact_algorithms)
            EXPECT_EQ(
                wrong_beyond_rounding(view, casters, light, lit_pixels(view, casters, light, by)),
                0)
                << scene << " by " << static_cast<int>(by);
    }
}

} // namespace
} // namespace keiko
