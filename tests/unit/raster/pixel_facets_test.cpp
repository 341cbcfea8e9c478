#include "keiko/raster/pixel_facets.h"

#include "keiko/raster/mesh_view.h"
#include "keiko/raster/patch_subdivision.h"

#include "tests/support/analytic_models.h"
#include "tests/support/hand_mesh.h"
#include "tests/support/model_builder.h"
#include "tests/support/picture_interior.h"
#include "tests/support/shapes.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace keiko {
namespace {

constexpr double radius = 30;

SurfaceModel sphere_model() {
    test::ShapeBuilder shape;
    shape.face(test::sphere(Vec3(0), radius));
    return shape.model();
}

TEST(PixelFacets, AreThoseOfTheFacesThatSubdivisionShows) {
    const SurfaceModel model = sphere_model();
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        const Camera camera = test::camera_on_x(100, 90, 70, projection);
        const ItemBuffer faces = subdivided_faces(model, camera);
        const PixelFacets facets = pixel_facets(model, camera);
        ASSERT_GT(facets.mesh.triangles.size(), 1000U);
        for (std::size_t i = 0; i < faces.shown.size(); ++i) {
            const std::uint32_t triangle = facets.items.shown[i];
            ASSERT_EQ(triangle == no_index, faces.shown[i] == no_index);
            if (triangle == no_index) continue;
            EXPECT_EQ(facets.mesh.faces[triangle], model.faces[faces.shown[i]].id);
        }
    }
}

TEST(PixelFacets, LieOnTheSurfaceWithinATenthOfAPixelOfItsHit) {
    const SurfaceModel model = sphere_model();
    const Camera camera = test::camera_on_x(100, 90, 70);
    const PixelFacets facets = pixel_facets(model, camera);
    for (std::size_t i = 0; i < facets.mesh.positions.size(); ++i) {
        EXPECT_NEAR(facets.mesh.positions[i].length(), radius, 1e-9);
        EXPECT_LT((facets.mesh.normals[i] - facets.mesh.positions[i] / radius).length(), 1e-7);
    }
    const MeshView view(facets.mesh, camera, facets.items);
    const double pixel = camera.pixel_size() * 100; // mm where the surface is farthest
    int compared = 0;
    double worst = 0; // pixels
    for (int y = 0; y < camera.height; ++y)
        for (int x = 0; x < camera.width; ++x) {
            const auto place = view.at(x, y);
            const Ray ray = camera.ray(x + 0.5, y + 0.5);
            const double along = -ray.origin.dot(ray.direction);
            const double half = radius * radius - (ray.at(along)).length2();
            if (!place || !(half > 0)) continue;
            const Vec3 hit = ray.at(along - std::sqrt(half));
            const double flat = -hit.dot(ray.direction) / radius;
            if (flat < 0.3) continue;
            ++compared;
            worst = std::max(worst, (place->position - hit).length() * flat / pixel);
            EXPECT_LT((place->normal - hit / radius).length(), pixel / flat / radius);
        }
    EXPECT_GT(compared, 1000);
    EXPECT_LT(worst, 0.1);
}

/// The largest angle between the facets of a picture and the sphere that they show, radians; pi for
/// one without area. Those more than 60 degrees from the eye's direction are left out.
double worst_tilt(const SurfaceModel& model, const Camera& camera) {
    const PixelFacets facets = pixel_facets(model, camera);
    const MeshView view(facets.mesh, camera, facets.items);
    double worst = 0;
    for (std::uint32_t t = 0; t < facets.mesh.triangles.size(); ++t) {
        const auto corners = view.corners(t);
        const Vec3 outward = ((corners[0] + corners[1] + corners[2]) / 3).normalized();
        if (outward.dot(camera.eye.normalized()) < 0.5) continue;
        const Vec3 normal = view.facet_normal(t);
        if (normal == Vec3(0)) return std::numbers::pi;
        const double tilt = angle_between(outward, normal);
        worst = std::max(worst, std::min(tilt, std::numbers::pi - tilt));
    }
    return worst;
}

TEST(PixelFacets, HaveTheNormalOfTheSurfaceAtPoles) {
    for (const double side : {1.0, -1.0})
        for (const int pixels : {90, 91}) { // the pole between four pixels, and in one's centre
            Camera camera = test::camera_on_x(100, pixels, pixels);
            camera.eye = Vec3(0, 0, 100 * side), camera.up = Vec3(0, 1, 0);
            const double pixel = camera.pixel_size() * 100; // mm
            EXPECT_LT(worst_tilt(sphere_model(), camera), 3 * pixel / radius) << side << pixels;
        }
}

TEST(PixelFacets, HaveAnAreaAtEachSideThatCollapses) {
    const Vec3 tip(0), a(0, 20, -17), b(0, 20, 19);
    for (const std::vector<Vec3>& corners :
         {std::vector{tip, tip, a, b}, {a, b, tip, tip}, {tip, a, tip, b}, {a, tip, b, tip}}) {
        test::ModelBuilder builder;
        builder.patch(1, 1, corners);
        builder.instance({});
        const SurfaceModel model = builder.build();
        const Camera camera = test::camera_on_x(100, 91, 91); // the tip in a pixel's centre
        const PixelFacets facets = pixel_facets(model, camera);
        const MeshView view(facets.mesh, camera, facets.items);
        ASSERT_GT(facets.mesh.triangles.size(), 100U);
        for (std::uint32_t t = 0; t < facets.mesh.triangles.size(); ++t)
            EXPECT_NEAR(std::abs(view.facet_normal(t).x), 1, 1e-6);
    }
}

TEST(PixelFacets, AreTheSameForAnyNumberOfThreads) {
    const SurfaceModel model = test::torus_model(30, 10);
    const Camera camera = test::camera_on_x(100, 80, 80);
    const PixelFacets one = pixel_facets(model, camera, {.threads = 1});
    const PixelFacets many = pixel_facets(model, camera, {.threads = 4});
    EXPECT_EQ(one.items.shown, many.items.shown);
    EXPECT_EQ(one.mesh.positions, many.mesh.positions);
    EXPECT_EQ(one.mesh.normals, many.mesh.normals);
}

} // namespace
} // namespace keiko
