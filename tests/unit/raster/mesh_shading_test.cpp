#include "keiko/raster/mesh_shading.h"

#include "keiko/raster/smooth_shading.h"

#include "tests/support/hand_mesh.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace keiko {
namespace {

/// A flat facet that fills the picture, whose normals fan out from the middle.
SurfaceMesh facet() {
    SurfaceMesh mesh;
    const auto normal = [](double y, double z) { return Vec3(1, y, z).normalized(); };
    test::add_triangle(mesh, {Vec3(0, -400, -200), Vec3(0, 400, -200), Vec3(0, 0, 400)},
                       {normal(-0.6, -0.3), normal(0.6, -0.3), normal(0, 0.6)});
    return mesh;
}

/// A narrow highlight of a light at the eye.
Rgb highlight(const ShadedPlace& lit) {
    return Rgb(std::pow(std::max(lit.eye.dot(lit.place.normal), 0.0), 400));
}

double brightest(const SurfaceMesh& mesh, const Camera& camera, MeshShading shading) {
    const Image image = shaded_mesh(MeshView(mesh, camera), shading, highlight);
    return double{*std::max_element(image.values.begin(), image.values.end())};
}

TEST(MeshShading, GouraudLosesAHighlightInsideAFacetThatPhongShows) {
    const SurfaceMesh mesh = facet();
    const Camera camera = test::camera_on_x(1000, 64, 64);
    EXPECT_LT(brightest(mesh, camera, MeshShading::gouraud), 1e-3);
    EXPECT_GT(brightest(mesh, camera, MeshShading::phong), 0.9); // half a pixel off its middle
}

TEST(MeshShading, ConstantShadingHasOneLuminanceAFacet) {
    const SurfaceMesh mesh = test::sphere_mesh(30, 8);
    const Camera camera = test::camera_on_x(100, 64, 64);
    const MeshView view(mesh, camera);
    const Image image = shaded_mesh(view, MeshShading::constant, highlight);
    std::vector<float> of_triangle(mesh.triangles.size(), -1);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x) {
            const std::uint32_t triangle = view.items().at(x, y);
            if (triangle == no_index) continue;
            float& known = of_triangle[triangle];
            if (known < 0) known = *image.pixel(x, y);
            EXPECT_EQ(*image.pixel(x, y), known);
        }
}

TEST(MeshShading, GouraudMixesTheCornersOfEachTriangle) {
    const SurfaceMesh mesh = facet();
    const Camera camera = test::camera_on_x(1000, 64, 64);
    // Linear on the facet in space, and so the same by any shading that is right in perspective.
    const PlaceLight height = [](const ShadedPlace& lit) {
        return Rgb(500 + lit.place.position.z);
    };
    const MeshView view(mesh, camera);
    const Image mixed = shaded_mesh(view, MeshShading::gouraud, height);
    const Image each = shaded_mesh(view, MeshShading::phong, height);
    for (std::size_t i = 0; i < mixed.values.size(); ++i)
        EXPECT_NEAR(mixed.values[i], each.values[i], 1e-4);
}

TEST(MeshShading, MixesOnlyWithinThinFacets) {
    // Slivers far thinner than a subpixel, which cover centres by rounding all the same.
    std::mt19937 random(7);
    std::uniform_real_distribution<double> share(-1, 1);
    SurfaceMesh mesh;
    for (int i = 0; i < 3000; ++i) {
        const auto anywhere = [&] { return Vec3(share(random), share(random), share(random)); };
        const Vec3 from = anywhere() * 250, to = anywhere() * 250;
        const Vec3 between = (from + to) / 2 + anywhere() * 0.5;
        test::add_triangle(
            mesh, {from, to, between},
            {anywhere().normalized(), anywhere().normalized(), anywhere().normalized()});
    }
    const Camera camera = test::camera_on_x(1000, 96, 96);
    const MeshView view(mesh, camera);
    std::size_t beside = 0;
    for (int y = 0; y < 96; ++y)
        for (int x = 0; x < 96; ++x) {
            const auto place = view.at(x, y);
            if (!place) continue;
            const Vec3& w = place->weights;
            EXPECT_GE(std::min({w.x, w.y, w.z}), 0);
            EXPECT_NEAR(w.x + w.y + w.z, 1, 1e-12);
            const Vec3 free =
                ray_weights(view.corners(place->triangle), camera.ray(x + 0.5, y + 0.5));
            beside += std::min({free.x, free.y, free.z}) < 0 ? 1 : 0;
        }
    EXPECT_GT(beside, 10U);
    const PlaceLight light = [](const ShadedPlace& lit) {
        return Rgb(std::abs(lit.eye.dot(lit.place.normal)));
    };
    for (const MeshShading shading : {MeshShading::gouraud, MeshShading::phong})
        for (const float value : shaded_mesh(view, shading, light).values) {
            EXPECT_GE(value, 0);
            EXPECT_LE(value, 1.00001F);
        }
}

TEST(MeshShading, MirroredRaysHaveTheDifferentialsOfASphere) {
    const SurfaceMesh mesh = test::sphere_mesh(30, 400);
    const Camera camera = test::camera_on_x(100, 64, 64);
    const MeshView view(mesh, camera);
    const auto mirrored = [&](int x, int y) { return view.mirrored(x, y, *view.at(x, y)); };
    const Ray here = mirrored(40, 30), beside = mirrored(41, 30), before = mirrored(39, 30);
    const Vec3 change = (beside.direction - before.direction) / 2;
    EXPECT_LT((here.differentials->direction_dx - change).length(), 0.02 * change.length());
    const Vec3 way = (beside.origin - before.origin) / 2;
    EXPECT_LT((here.differentials->origin_dx - way).length(), 0.02 * way.length());
}

} // namespace
} // namespace keiko
