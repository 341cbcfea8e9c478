#include "keiko/raster/z_buffer.h"

#include "keiko/raster/painter.h"
#include "keiko/raster/scan_line.h"
#include "keiko/raster/smooth_shading.h"
#include "keiko/raster/triangle_scan.h"

#include "tests/support/hand_mesh.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>
#include <set>

namespace keiko {
namespace {

using test::add_triangle;

/// The nearest triangle on the ray through a place of the picture, by ray against each of them.
std::uint32_t nearest(const SurfaceMesh& mesh, const Camera& camera, double x, double y) {
    const Ray ray = camera.ray(x, y);
    double first = std::numeric_limits<double>::infinity();
    std::uint32_t found = no_index;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const std::array<Vec3, 3> corners{mesh.positions[a], mesh.positions[b], mesh.positions[c]};
        const Vec3 weights = ray_weights(corners, ray);
        const double at = (mixed(weights, corners) - ray.origin).dot(ray.direction);
        if (std::min({weights.x, weights.y, weights.z}) < 0 || !(at > 0) || !(at < first)) continue;
        first = at, found = t;
    }
    return found;
}

/// Number of pixels whose triangle no ray within a subpixel of their centre meets first.
int wrong_pixels(const SurfaceMesh& mesh, const Camera& camera, const ItemBuffer& items) {
    constexpr double subpixel = 1.0 / 256;
    int wrong = 0;
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            std::set<std::uint32_t> met;
            for (const double dx : {0.0, -subpixel, subpixel})
                for (const double dy : {0.0, -subpixel, subpixel})
                    met.insert(nearest(mesh, camera, x + 0.5 + dx, y + 0.5 + dy));
            wrong += met.contains(items.at(x, y)) ? 0 : 1;
        }
    return wrong;
}

/// Triangles all around the origin, some through the eye's plane and beyond the picture.
SurfaceMesh random_triangles(int count, double reach) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-reach, reach);
    const auto point = [&] { return Vec3(place(random), place(random), place(random)); };
    SurfaceMesh mesh;
    for (int i = 0; i < count; ++i) {
        const Vec3 a = point(), b = a + point() / 3, c = a + point() / 3;
        add_triangle(mesh, {a, b, c});
    }
    return mesh;
}

TEST(ZBuffer, AgreesWithRaysThroughTrianglesOnBothSidesOfTheEye) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const SurfaceMesh mesh = random_triangles(200, 150);
        const Camera camera = test::camera_on_x(100, 96, 80, projection);
        const ItemBuffer items = z_buffer(mesh, camera);
        EXPECT_EQ(wrong_pixels(mesh, camera, items), 0);
        const std::set<std::uint32_t> shown(items.shown.begin(), items.shown.end());
        EXPECT_GT(shown.size(), 10U);
    }
}

TEST(ZBuffer, ClipsTrianglesThatReachFarBesideThePicture) {
    SurfaceMesh mesh;
    add_triangle(mesh, {Vec3(-50, -1e7, -1e7), Vec3(-50, 3e7, -1e7), Vec3(-50, -1e7, 3e7)});
    add_triangle(mesh, {Vec3(1e6, 0, -10), Vec3(-1e6, 10, -10), Vec3(-1e6, -10, -10)});
    const Camera camera = test::camera_on_x(100, 64, 64);
    const ItemBuffer items = z_buffer(mesh, camera);
    EXPECT_EQ(wrong_pixels(mesh, camera, items), 0);
    EXPECT_EQ(items.at(0, 0), 0U);
    EXPECT_EQ(items.at(32, 40), 1U);
}

TEST(ZBuffer, HasTheSameTrianglesForAnyNumberOfThreads) {
    const SurfaceMesh mesh = test::sphere_mesh(30, 100);
    const Camera camera = test::camera_on_x(100, 300, 200);
    EXPECT_EQ(z_buffer(mesh, camera, {.threads = 1}).shown,
              z_buffer(mesh, camera, {.threads = 4}).shown);
}

TEST(ZBuffer, ShowsTheFirstOfTwoTrianglesAtOneDepth) {
    SurfaceMesh mesh;
    for (int i = 0; i < 2; ++i)
        add_triangle(mesh, {Vec3(0, -9, -9), Vec3(0, 9, -9), Vec3(0, 0, 9)});
    const ItemBuffer items = z_buffer(mesh, test::camera_on_x(100, 32, 32));
    EXPECT_EQ(items.at(16, 16), 0U);
    EXPECT_EQ(std::count(items.shown.begin(), items.shown.end(), 1U), 0);
}

TEST(ScanLine, ShowsTheTrianglesOfTheZBuffer) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const Camera camera = test::camera_on_x(100, 97, 80, projection);
        for (const SurfaceMesh& mesh : {random_triangles(300, 150), test::sphere_mesh(30, 60)})
            EXPECT_EQ(scan_line(mesh, camera).shown, z_buffer(mesh, camera).shown);
    }
}

TEST(Painter, ShowsTheTrianglesOfTheZBuffer) {
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const Camera camera = test::camera_on_x(100, 97, 80, projection);
        for (const SurfaceMesh& mesh : {random_triangles(300, 150), test::sphere_mesh(30, 60)})
            EXPECT_EQ(painted_triangles(mesh, camera).shown, z_buffer(mesh, camera).shown);
    }
}

TEST(Painter, CutsThreeTrianglesThatOverlapInACircle) {
    // Each lies before the next and behind the one before it: no order of whole triangles is right.
    SurfaceMesh mesh;
    for (int i = 0; i < 3; ++i) {
        const double angle = i * 2 * std::numbers::pi / 3;
        const auto turned = [&](double x, double y, double z) {
            return Vec3(x, y * std::cos(angle) - z * std::sin(angle),
                        y * std::sin(angle) + z * std::cos(angle));
        };
        add_triangle(mesh, {turned(-5, -25, -8), turned(-5, -25, -14), turned(5, 25, -11)});
    }
    const Camera camera = test::camera_on_x(100, 120, 120);
    const ItemBuffer seen = painted_triangles(mesh, camera);
    EXPECT_EQ(seen.shown, z_buffer(mesh, camera).shown);
    EXPECT_EQ(std::set<std::uint32_t>(seen.shown.begin(), seen.shown.end()).size(), 4U);
}

TEST(ScanLine, HasTheSameTrianglesForAnyNumberOfThreads) {
    const SurfaceMesh mesh = random_triangles(300, 150);
    const Camera camera = test::camera_on_x(100, 300, 200);
    EXPECT_EQ(scan_line(mesh, camera, {.threads = 1}).shown,
              scan_line(mesh, camera, {.threads = 4}).shown);
}

/// Corners of a grid of 4 x 4 cells over 40 x 40 pixels, those within moved at random to
/// subpixels, many onto pixel centres.
std::vector<ScreenCorner> moved_grid(std::mt19937& random) {
    std::uniform_int_distribution<int> move(-4, 4);
    constexpr int half = subpixels / 2;
    std::vector<ScreenCorner> corners;
    for (int j = 0; j <= 4; ++j)
        for (int i = 0; i <= 4; ++i) {
            const bool inner = i > 0 && i < 4 && j > 0 && j < 4;
            const int x = inner ? move(random) * half : 0, y = inner ? move(random) * half : 0;
            corners.push_back({static_cast<std::int32_t>(i * 10 * subpixels + x),
                               static_cast<std::int32_t>(j * 10 * subpixels + y), 1});
        }
    return corners;
}

TEST(TriangleScan, CoversEachPixelOfATiledSquareOnce) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 50; ++trial) {
        const std::vector<ScreenCorner> corners = moved_grid(random);
        std::vector<int> covered(40 * 40);
        const auto scan = [&](int a, int b, int c) {
            const auto at = [&](int i) { return corners[static_cast<std::size_t>(i)]; };
            scan_triangle({at(a), at(b), at(c)}, {0, 0, 39, 39}, [&](int x, int y, double) {
                ++covered[static_cast<std::size_t>(y * 40 + x)];
            });
        };
        for (int j = 0; j < 4; ++j)
            for (int i = 0; i < 4; ++i) {
                const int a = j * 5 + i;
                scan(a, a + 1, a + 6), scan(a + 5, a, a + 6); // of either sense
            }
        EXPECT_EQ(std::count(covered.begin(), covered.end(), 1), 40 * 40) << trial;
    }
}

} // namespace
} // namespace keiko
