#include "keiko/radiosity/reflected_light.h"

#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <numbers>

namespace keiko {
namespace {

/// The plate of a stage as two elements under light that rises along x on its front.
ReflectedLight sloping_light() {
    RadiositySolution solution;
    solution.corners = {{-1000, -1000, 0}, {1000, -1000, 0}, {1000, 1000, 0}, {-1000, 1000, 0}};
    solution.triangles = {{0, 1, 2}, {0, 2, 3}};
    const ElementLight back{Rgb(1e6), Rgb(1e6)};
    solution.light = {{ElementLight{Rgb(400, 200, 100), Rgb()}, back},
                      {ElementLight{Rgb(200, 100, 50), Rgb()}, back}};
    return ReflectedLight(solution);
}

// Lambert's rho E / pi, of the solution's light and not of the ambient.
TEST(ReflectedLightPicture, HasLambertsLuminanceOfTheSolutionInThePlaceOfAmbientLight) {
    test::Stage stage(test::flat_plate(), 1);
    stage.rig.sources.clear();
    stage.rig.ambient = Rgb(12345);
    const ReflectedLight light = sloping_light();
    PictureScene scene{stage.tracer, stage.materials, stage.rig, Rgb(7)};
    scene.reflected = &light;
    const Film film = render(scene, stage.camera, {});
    const PreparedCamera camera(stage.camera);
    int compared = 0;
    for (const int x : {30, 48, 60}) {
        const int y = 27;
        const auto hit = stage.tracer.nearest(camera.ray(x + 0.5, y + 0.5));
        ASSERT_TRUE(hit);
        const Rgb lx = light.on_surface(hit->position, Vec3(0, 0, 1)).value();
        const Rgb expected = stage.materials[0].diffuse * lx / std::numbers::pi;
        const float* shown = film.color.pixel(x, y);
        EXPECT_NEAR(shown[0], expected.r, 1e-4 * expected.r);
        EXPECT_NEAR(shown[2], expected.b, 1e-4 * expected.b);
        compared += expected.r > 5 ? 1 : 0;
    }
    EXPECT_EQ(compared, 3);
}

} // namespace
} // namespace keiko
