#include "keiko/api/scene.h"

#include "tests/support/paths.h"
#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <fstream>

namespace keiko {
namespace {

/// A saddle of 200 mm that touches z = -25 and 25, in a scene with some more lines.
class GroundScene : public testing::Test {
protected:
    Scene open(const std::string& lines) {
        const auto file = folder_ / "scene.toml";
        std::ofstream(file) << "format = \"keiko-scene/1\"\n"
                            << lines << "[[model]]\nfile = \""
                            << test::repository("surfaces/saddle.bpt").string()
                            << "\"\nmaterial = \"mirror\"\n";
        const std::filesystem::path inputs[] = {file};
        return open_scene(inputs);
    }

    test::TemporaryFolder temporary_;
    const std::filesystem::path& folder_ = temporary_.path();
};

const LightRig even{.name = "", .sources = {}, .ambient = Rgb(100), .medium = {}};

Camera camera_from_aside() {
    Camera camera;
    camera.eye = {-900, 0, 500};
    camera.target = Vec3(0);
    camera.width = camera.height = 32;
    return camera;
}

} // namespace

TEST_F(GroundScene, PicturesShowTheGroundAndNothingElseKnowsOfIt) {
    const Scene bare = open(""), grounded = open("ground = { z = -60 }\n");
    EXPECT_EQ(grounded.model.faces.size(), bare.model.faces.size());
    EXPECT_EQ(grounded.tracer.bounds().upper, bare.tracer.bounds().upper);
    const Ray down{.origin = {5000, 3000, 100}, .direction = {0, 0, -1}};
    EXPECT_FALSE(grounded.tracer.nearest(down));
    const auto hit = grounded.seen().nearest(down);
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->t, 160, 1e-6);
    EXPECT_EQ(hit->face, bare.model.faces.size());
    EXPECT_EQ(grounded.seen_materials().back().name, "concrete");
    const Camera camera = camera_from_aside();
    EXPECT_EQ(render_view(bare, even, camera).alpha.pixel(1, 1)[0], 0);
    const Film film = render_view(grounded, even, camera);
    EXPECT_EQ(film.alpha.pixel(1, 1)[0], 1);
    EXPECT_NEAR(film.color.pixel(1, 1)[0], 0.36 * 100 / std::numbers::pi, 1e-3);
}

TEST_F(GroundScene, StandingEyesStandOnIt) {
    const Scene grounded = open("ground = { z = -60 }\n");
    const std::string names[] = {"standing-front"};
    EXPECT_DOUBLE_EQ(choose_views(grounded, names, 1).front().camera.eye.z, -60 + 1650);
}

// The saddle mirrors the ground, and past it the even light.
TEST_F(GroundScene, ReflectionsFollowTheLimitsOfTheScene) {
    const Camera camera = camera_from_aside();
    const auto middle = [&](const Scene& scene) {
        return static_cast<double>(render_view(scene, even, camera).color.pixel(16, 16)[0]);
    };
    const double mirrored = middle(open(""));
    EXPECT_NEAR(mirrored, 100 / std::numbers::pi * 0.98, 0.5);
    EXPECT_EQ(middle(open("max_depth = 0\n")), 0);
    EXPECT_EQ(middle(open("min_weight = 0.99\n")), 0);
}

} // namespace keiko
