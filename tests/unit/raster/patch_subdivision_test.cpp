#include "keiko/raster/patch_subdivision.h"

#include "tests/support/analytic_models.h"
#include "tests/support/hand_mesh.h"
#include "tests/support/picture_interior.h"
#include "tests/support/shapes.h"
#include "tests/support/traced_faces.h"
#include <gtest/gtest.h>

#include <algorithm>

namespace keiko {
namespace {

int shown_faces(const ItemBuffer& buffer) {
    return static_cast<int>(std::count_if(buffer.shown.begin(), buffer.shown.end(),
                                          [](std::uint32_t face) { return face != no_index; }));
}

TEST(PatchSubdivision, ShowsTheFacesOfTheTracerButAtEdges) {
    test::ShapeBuilder shape; // a plate with a hole before a sphere, seen from above
    shape.face({test::rectangle(-30, 30, -30, 30, 40)},
               {test::polygon({Vec2(-30, -30), Vec2(30, -30), Vec2(30, 30), Vec2(-30, 30)}),
                test::circle(Vec2(5, 3), 18)});
    shape.face(test::sphere(Vec3(0), 30));
    for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
        Camera camera = test::camera_on_x(200, 90, 70, projection);
        camera.eye = Vec3(40, 30, 200);
        const ItemBuffer truth = test::traced_faces(shape.model(), camera);
        const ItemBuffer seen = subdivided_faces(shape.model(), camera);
        EXPECT_EQ(test::wrong_inside(truth, seen), 0);
        EXPECT_NEAR(shown_faces(seen), shown_faces(truth), 0.08 * shown_faces(truth));
        for (const std::uint32_t face : {0U, 1U})
            EXPECT_GT(std::count(seen.shown.begin(), seen.shown.end(), face), 100) << face;
    }
}

TEST(PatchSubdivision, ShowsWhatReachesBehindTheEye) {
    test::ShapeBuilder shape;
    shape.face({test::rectangle(-500, 500, -500, 500, -10)});
    const Camera camera = test::camera_on_x(100, 64, 64);
    EXPECT_EQ(test::wrong_inside(test::traced_faces(shape.model(), camera),
                                 subdivided_faces(shape.model(), camera)),
              0);
}

TEST(PatchSubdivision, HasTheSameFacesForAnyNumberOfThreads) {
    const SurfaceModel model = test::torus_model(30, 10);
    const Camera camera = test::camera_on_x(100, 80, 80);
    EXPECT_EQ(subdivided_faces(model, camera, {.threads = 1}).shown,
              subdivided_faces(model, camera, {.threads = 4}).shown);
}

} // namespace
} // namespace keiko
