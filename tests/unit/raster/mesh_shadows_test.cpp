#include "keiko/raster/mesh_shadows.h"

#include "keiko/raster/lit_pixels.h"

#include "tests/support/mesh_light.h"
#include "tests/support/picture_interior.h"
#include "tests/support/sphere_and_plate.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace keiko {
namespace {

using test::camera_above, test::floor_z, test::is_inside, test::plate_z, test::sphere_and_plate,
    test::wrong_beyond_rounding, test::wrong_inside;

constexpr std::array every_algorithm{MeshShadows::ray, MeshShadows::scan_line, MeshShadows::map,
                                     MeshShadows::polygons, MeshShadows::volumes};

const std::vector<Viewpoint>& lights() {
    static const std::vector<Viewpoint> all{Viewpoint::at({-90, 30, 160}), // one map sees all of it
                                            Viewpoint::at({-40, 20, -15}), // in the midst
                                            Viewpoint::towards({-0.5, 0.3, 1})};
    return all;
}

/// The others are exact; a map seen at a flat angle errs by several pixels of the view.
int most_wrong(MeshShadows by) {
    return by == MeshShadows::map ? 8 : 0; // of 8000 pixels
}

int lit_count(const Image& image) {
    return static_cast<int>(std::count(image.values.begin(), image.values.end(), 1.0F));
}

TEST(MeshShadows, AllAlgorithmsAgreeButAtEdges) {
    const SurfaceMesh mesh = sphere_and_plate(16);
    const ShadowCasters casters(mesh);
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const Camera camera = camera_above(projection);
        const MeshView view(mesh, camera);
        for (const Viewpoint& light : lights()) {
            const Image truth = lit_pixels(view, casters, light, MeshShadows::ray);
            EXPECT_GT(lit_count(truth), 900);
            EXPECT_LT(lit_count(truth),
                      lit_count(lit_pixels(view, casters, light, MeshShadows::none)) - 200);
            for (const MeshShadows by : every_algorithm) {
                const Image other = lit_pixels(view, casters, light, by);
                EXPECT_LE(wrong_inside(truth, other), most_wrong(by)) << static_cast<int>(by);
                EXPECT_NEAR(lit_count(other), lit_count(truth), 0.01 * lit_count(truth))
                    << static_cast<int>(by);
            }
        }
    }
}

TEST(MeshShadows, AgreeOnTrianglesThatPierceEachOther) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> place(-60, 60);
    const auto point = [&] { return Vec3(place(random), place(random), place(random)); };
    SurfaceMesh mesh;
    for (int i = 0; i < 80; ++i) {
        const Vec3 a = point();
        test::add_triangle(mesh, {a, a + point() / 2, a + point() / 2});
    }
    const ShadowCasters casters(mesh);
    const Camera camera = camera_above();
    const MeshView view(mesh, camera);
    for (const Viewpoint& light : lights()) {
        const Image truth = lit_pixels(view, casters, light, MeshShadows::ray);
        EXPECT_GT(lit_count(truth), 90);
        for (const MeshShadows by : every_algorithm)
            EXPECT_LE(
                wrong_beyond_rounding(view, casters, light, lit_pixels(view, casters, light, by)),
                most_wrong(by))
                << static_cast<int>(by);
    }
}

/// True if the sphere lies between a place and a light.
bool in_shadow_of_sphere(const Vec3& place, const Viewpoint& light, double r) {
    const Vec3 way = -light.way_to(place);
    const double along = -place.dot(way) / way.length2();
    return along > 0 && (light.infinite() || along < 1) && (place + way * along).length() < r;
}

bool in_shadow_of_plate(const Vec3& place, const Viewpoint& light) {
    const Vec3 way = -light.way_to(place);
    const double along = (plate_z - place.z) / way.z;
    const Vec3 met = place + way * along;
    return along > 0 && (light.infinite() || along < 1) && met.x > 40 && met.x < 70 &&
           std::abs(met.y) < 20;
}

TEST(MeshShadows, AreThoseOfTheSphereAndThePlateInClosedForm) {
    const SurfaceMesh mesh = sphere_and_plate(40);
    const double deviation =
        test::sphere_radius * (1 - std::pow(std::cos(std::numbers::pi / 80), 2));
    const ShadowCasters casters(mesh);
    const Camera camera = camera_above();
    const MeshView view(mesh, camera);
    for (const Viewpoint& light : lights())
        for (const MeshShadows by : every_algorithm) {
            const Image lit = lit_pixels(view, casters, light, by);
            int dark = 0, wrong = 0;
            for (int y = 0; y < lit.height; ++y)
                for (int x = 0; x < lit.width; ++x) {
                    const auto place = view.at(x, y);
                    if (!place || std::abs(place->position.z - floor_z) > 1e-6) continue;
                    const Vec3& p = place->position;
                    // Between both radii the mesh decides; of the map also its pixels.
                    const double more = by == MeshShadows::map ? 0.3 : 0;
                    const bool plate = in_shadow_of_plate(p, light);
                    const bool surely =
                        in_shadow_of_sphere(p, light, test::sphere_radius - deviation - more);
                    const bool maybe = in_shadow_of_sphere(p, light, test::sphere_radius + more);
                    const bool is_dark = *lit.pixel(x, y) == 0;
                    dark += is_dark ? 1 : 0;
                    if (surely == maybe && (by != MeshShadows::map || is_inside(lit, x, y)))
                        wrong += is_dark != (surely || plate) ? 1 : 0;
                }
            EXPECT_EQ(wrong, 0) << static_cast<int>(by);
            EXPECT_GT(dark, 130);
        }
}

TEST(MeshShadows, VolumesCountFromAnEyeInTheShadow) {
    const SurfaceMesh mesh = sphere_and_plate(16);
    const ShadowCasters casters(mesh);
    const Viewpoint light = Viewpoint::towards({-0.2, 0, 1});
    Camera camera = camera_above();
    camera.eye = Vec3(5, 2, -40), camera.target = Vec3(200, 30, -50), camera.vertical_fov = 60;
    ASSERT_GT(casters.layers(camera.eye, light), 0);
    const MeshView view(mesh, camera);
    const Image truth = lit_pixels(view, casters, light, MeshShadows::ray);
    EXPECT_GT(lit_count(truth), 500);
    EXPECT_EQ(wrong_inside(truth, lit_pixels(view, casters, light, MeshShadows::volumes)), 0);
}

/// A ceiling in two triangles over a scene.
Vec3 on_ceiling(double x, double y) {
    return {x, y, 160 + 0.3 * x + 0.1 * y};
}

void add_ceiling(SurfaceMesh& mesh) {
    const Vec3 a = on_ceiling(-290, -280), b = on_ceiling(310, -270), c = on_ceiling(270, 290),
               d = on_ceiling(-300, 260);
    test::add_triangle(mesh, {a, b, c}), test::add_triangle(mesh, {a, c, d});
}

/// Pixels that show the begin of a mesh in which two pictures differ.
int different(const MeshView& view, std::size_t triangles, const Image& a, const Image& b) {
    int count = 0;
    for (int y = 0; y < a.height; ++y)
        for (int x = 0; x < a.width; ++x)
            if (const auto place = view.at(x, y); place && place->triangle < triangles)
                count += *a.pixel(x, y) != *b.pixel(x, y) ? 1 : 0;
    return count;
}

TEST(MeshShadows, OfALampFlushWithACeilingAreThoseWithoutIt) {
    const SurfaceMesh open = sphere_and_plate(16);
    SurfaceMesh closed = open;
    add_ceiling(closed);
    const ShadowCasters without(open), with(closed);
    const Camera camera = camera_above();
    const MeshView view(closed, camera);
    for (const Vec2& at : {Vec2(-90.1, 30.3), Vec2(-20.7, 10.1), Vec2(60.3, -70.9)}) {
        const Viewpoint light = Viewpoint::at(on_ceiling(at.x, at.y));
        for (const MeshShadows by : every_algorithm) {
            const Image truth = lit_pixels(view, without, light, by);
            EXPECT_GT(lit_count(truth), 900);
            EXPECT_LE(
                different(view, open.triangles.size(), truth, lit_pixels(view, with, light, by)),
                by == MeshShadows::map ? 40 : 0)
                << static_cast<int>(by);
        }
    }
}

TEST(MeshShadows, AreTheSameForAnyNumberOfThreads) {
    const SurfaceMesh mesh = sphere_and_plate(16);
    const ShadowCasters casters(mesh);
    const Camera camera = camera_above();
    const MeshView view(mesh, camera);
    for (const MeshShadows by : every_algorithm)
        EXPECT_EQ(lit_pixels(view, casters, lights()[0], by, {.threads = 1}).values,
                  lit_pixels(view, casters, lights()[0], by, {.threads = 4}).values);
}

} // namespace
} // namespace keiko
