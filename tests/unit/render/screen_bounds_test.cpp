#include "keiko/render/tiles.h"

#include "tests/unit/render/stage.h"
#include <gtest/gtest.h>

#include <vector>

using namespace keiko;
using test::Stage;

namespace {

/// Two small domed plates far apart, one above and behind the other.
SurfaceModel two_domes() {
    test::ModelBuilder builder;
    for (const Vec3& corner : {Vec3(-700, -200, 0), Vec3(400, 600, 500)}) {
        std::vector<Vec3> points;
        for (int i = 0; i <= 3; ++i)
            for (int j = 0; j <= 3; ++j) {
                const bool middle = i % 3 != 0 && j % 3 != 0;
                points.push_back(corner + Vec3(120 * i, 120 * j, middle ? 250 : 0));
            }
        builder.patch(3, 3, points);
    }
    return builder.build();
}

/// Pixels, those beside the border with them, that may show the model. Of all others expects that
/// no ray through them meets it.
int shown(const Tracer& tracer, const Camera& camera) {
    const ScreenBounds cover(camera, tracer.boxes());
    int shown = 0;
    for (int y = -1; y <= camera.height; ++y)
        for (int x = -1; x <= camera.width; ++x) {
            if (cover.may_show(x, y)) {
                ++shown;
                continue;
            }
            for (const double dy : {0.0, 0.5, 0.999})
                for (const double dx : {0.0, 0.5, 0.999})
                    EXPECT_FALSE(tracer.nearest(camera.ray(x + dx, y + dy))) << x << ' ' << y;
        }
    return shown;
}

int pixels(const Camera& camera) {
    return (camera.width + 2) * (camera.height + 2);
}

} // namespace

TEST(ScreenBounds, HoldsTheModelFromAnySide) {
    Stage stage(two_domes());
    for (const Vec3& eye :
         {Vec3(0, -3000, 1500), Vec3(2500, 300, 200), Vec3(-900, -900, 2900), Vec3(0, 0, -2000)})
        for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
            stage.camera.eye = eye;
            stage.camera.projection = projection, stage.camera.orthographic_height = 1500;
            const int number = shown(stage.tracer, stage.camera);
            EXPECT_GT(number, 0);
            EXPECT_LT(number, pixels(stage.camera) / 2);
        }
}

TEST(ScreenBounds, HoldsWhatIsPartlyBesideThePicture) {
    Stage stage(two_domes());
    stage.camera.target = {-700, -200, 0};
    stage.camera.vertical_fov = 6;
    const int number = shown(stage.tracer, stage.camera);
    EXPECT_GT(number, 0);
    EXPECT_LT(number, pixels(stage.camera));
}

// The nearer dome is around the eye, so that corners of its box are behind it.
TEST(ScreenBounds, IsAllThatTheEyeSeesAmidTheModel) {
    Stage stage(two_domes());
    stage.camera.eye = {-520, -20, 60};
    stage.camera.target = {580, 780, 560};
    EXPECT_EQ(shown(stage.tracer, stage.camera), pixels(stage.camera));
}

TEST(ScreenBounds, IsEmptyWithoutAModel) {
    const Camera camera;
    const ScreenBounds cover(camera, {});
    EXPECT_FALSE(cover.may_show(0, 0));
    EXPECT_FALSE(cover.may_show(camera.width, camera.height));
}

// Enough boxes that some are taken together.
TEST(ScreenBounds, HoldsEachOfVeryManyBoxes) {
    Camera camera;
    camera.eye = {0, 0, 1000}, camera.target = Vec3(0), camera.up = {0, 1, 0};
    camera.width = 320, camera.height = 180;
    std::vector<Box3> boxes;
    for (int i = 0; i < 300; ++i)
        for (int j = 0; j < 300; ++j) {
            const Vec3 at(-400 + 2.0 * i, -300 + 2.0 * j, 0);
            boxes.push_back({at, at + Vec3(1, 1, 1)});
        }
    const ScreenBounds cover(camera, boxes);
    for (const Box3& box : boxes) {
        const auto at = project(camera, box.center());
        if (at->x < 0 || at->y < 0 || at->x >= camera.width || at->y >= camera.height) continue;
        EXPECT_TRUE(cover.may_show(static_cast<int>(at->x), static_cast<int>(at->y)));
    }
    EXPECT_FALSE(cover.may_show(319, 90));
}
