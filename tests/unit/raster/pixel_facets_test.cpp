#include "keiko/raster/pixel_facets.h"

#include "keiko/raster/mesh_view.h"
#include "keiko/raster/patch_subdivision.h"

#include "tests/support/analytic_models.h"
#include "tests/support/hand_mesh.h"
#include "tests/support/picture_interior.h"
#include "tests/support/shapes.h"
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

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
