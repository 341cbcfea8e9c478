#include "keiko/raster/mesh_shadows.h"

#include "keiko/raster/light_cone.h"
#include "keiko/raster/lit_pixels.h"
#include "keiko/raster/smooth_shading.h"

#include "tests/support/hand_mesh.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace keiko {
namespace {

constexpr std::array every_algorithm{MeshShadows::ray, MeshShadows::scan_line, MeshShadows::map,
                                     MeshShadows::polygons, MeshShadows::volumes};
constexpr double radius = 30, floor_z = -45, plate_z = -38;

/// A rectangle across z in two triangles; upwards.
void add_plate(SurfaceMesh& mesh, const Vec2& low, const Vec2& high, double z) {
    test::add_triangle(mesh,
                       {Vec3(low.x, low.y, z), Vec3(high.x, low.y, z), Vec3(high.x, high.y, z)});
    test::add_triangle(mesh,
                       {Vec3(low.x, low.y, z), Vec3(high.x, high.y, z), Vec3(low.x, high.y, z)});
}

/// A sphere about the origin and a plate over a floor.
SurfaceMesh sphere_and_plate(int cells) {
    SurfaceMesh mesh = test::sphere_mesh(radius, cells);
    add_plate(mesh, Vec2(-300), Vec2(300), floor_z);
    add_plate(mesh, Vec2(40, -20), Vec2(70, 20), plate_z);
    return mesh;
}

Camera camera_above(Projection projection = Projection::perspective) {
    Camera camera = test::camera_on_x(260, 100, 80, projection);
    camera.eye = Vec3(170, 120, 130), camera.target = Vec3(10, 0, -30);
    return camera;
}

const std::vector<Viewpoint>& lights() {
    static const std::vector<Viewpoint> all{Viewpoint::at({-90, 30, 160}), // one map sees all of it
                                            Viewpoint::at({-40, 20, -15}), // in the midst
                                            Viewpoint::towards({-0.5, 0.3, 1})};
    return all;
}

/// True if all pixels around one are as it is.
bool is_inside(const Image& image, int x, int y) {
    if (x < 1 || y < 1 || x + 1 >= image.width || y + 1 >= image.height) return false;
    for (int j = -1; j <= 1; ++j)
        for (int i = -1; i <= 1; ++i)
            if (*image.pixel(x + i, y + j) != *image.pixel(x, y)) return false;
    return true;
}

/// Pixels off the edges of shadows in which two pictures differ.
int wrong_inside(const Image& truth, const Image& other) {
    int wrong = 0;
    for (int y = 0; y < truth.height; ++y)
        for (int x = 0; x < truth.width; ++x)
            wrong += is_inside(truth, x, y) && *other.pixel(x, y) != *truth.pixel(x, y) ? 1 : 0;
    return wrong;
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

/// Pixels off edges of triangles whose light no ray has that starts within a subpixel of the
/// centre.
int wrong_beyond_rounding(const MeshView& view, const ShadowCasters& casters,
                          const Viewpoint& light, const Image& lit) {
    constexpr double subpixel = 1.0 / 256;
    int wrong = 0;
    const auto is_lit = [&](std::uint32_t triangle, double x, double y) {
        const auto corners = view.corners(triangle);
        const Vec3 place = mixed(ray_weights(corners, view.camera().ray(x, y)), corners);
        return faces_light(view, triangle, light) && !casters.hide(place, light, triangle);
    };
    for (int y = 0; y < lit.height; ++y)
        for (int x = 0; x < lit.width; ++x) {
            const auto place = view.at(x, y);
            const Vec3 w = place ? place->weights : Vec3(0);
            if (!(std::min({w.x, w.y, w.z}) > 0.01)) continue;
            bool right = false;
            for (const double dx : {0.0, -subpixel, subpixel})
                for (const double dy : {0.0, -subpixel, subpixel})
                    right |= is_lit(place->triangle, x + 0.5 + dx, y + 0.5 + dy) ==
                             (*lit.pixel(x, y) > 0);
            wrong += right ? 0 : 1;
        }
    return wrong;
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
    const double deviation = radius * (1 - std::pow(std::cos(std::numbers::pi / 80), 2));
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
                    const bool surely = in_shadow_of_sphere(p, light, radius - deviation - more);
                    const bool maybe = in_shadow_of_sphere(p, light, radius + more);
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

TEST(MeshShadows, AreTheSameForAnyNumberOfThreads) {
    const SurfaceMesh mesh = sphere_and_plate(16);
    const ShadowCasters casters(mesh);
    const Camera camera = camera_above();
    const MeshView view(mesh, camera);
    for (const MeshShadows by : every_algorithm)
        EXPECT_EQ(lit_pixels(view, casters, lights()[0], by, {.threads = 1}).values,
                  lit_pixels(view, casters, lights()[0], by, {.threads = 4}).values);
}

/// Points that stand for equal parts of a sphere, along a spiral.
std::vector<EmittingPoint> points_of(const LightSphere& sphere, int count) {
    std::vector<EmittingPoint> points;
    for (int i = 0; i < count; ++i) {
        const double z = 1 - (2 * i + 1.0) / count, flat = std::sqrt(1 - z * z);
        const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
        const Vec3 normal(flat * std::cos(turn), flat * std::sin(turn), z);
        points.push_back({sphere.center + normal * sphere.radius, normal, 1});
    }
    return points;
}

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

} // namespace
} // namespace keiko
