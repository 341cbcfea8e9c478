#include "keiko/radiosity/reflected_light.h"

#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <numbers>

namespace keiko {
namespace {

/// The plate of a stage as two elements under light that rises along x on its front.
ReflectedLight sloping_light(const test::Stage& stage) {
    RadiositySolution solution;
    solution.corners = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    solution.triangles = {{{0, 1, 2}, 0, 0, 0}, {{0, 2, 3}, 1, 0, 0}};
    solution.elements = 2;
    LampSolution lamp;
    for (const Vec2& corner : solution.corners)
        lamp.arriving.push_back({Rgb(400, 200, 100) * (0.5 + corner.x / 2), Rgb(1e6)});
    lamp.exitance.resize(2);
    solution.lamps = {lamp};
    const std::vector<Rgb> level{Rgb(1)}, reflectances{stage.materials[0].diffuse};
    return ReflectedLight(solution, level, reflectances, stage.model, stage.tracer);
}

// Lambert's rho E / pi, of the solution's light and not of the ambient.
TEST(ReflectedLightPicture, HasLambertsLuminanceOfTheSolutionInThePlaceOfAmbientLight) {
    test::Stage stage(test::flat_plate(), 1);
    stage.rig.sources.clear();
    stage.rig.ambient = Rgb(12345);
    const ReflectedLight light = sloping_light(stage);
    PictureScene scene{stage.tracer, stage.materials, stage.rig, Rgb(7)};
    scene.reflected = &light;
    const Film film = render(scene, stage.camera, {});
    const PreparedCamera camera(stage.camera);
    int compared = 0;
    for (const int x : {30, 48, 60}) {
        const int y = 27;
        const auto hit = stage.tracer.nearest(camera.ray(x + 0.5, y + 0.5));
        ASSERT_TRUE(hit);
        const Rgb lx = light.on_surface(hit->root, Vec3(0, 0, 1)).value();
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
