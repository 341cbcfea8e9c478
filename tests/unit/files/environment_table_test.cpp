#include "keiko/base/error.h"
#include "keiko/files/scene/scene_file.h"

#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

#include <fstream>
#include <string>

namespace keiko {
namespace {

/// Parses scenes beside a picture and a model, which are not read.
class Scenes {
public:
    Scenes() {
        for (const char* name : {"studio.exr", "body.step"})
            std::ofstream(folder_.path() / name) << name;
    }
    SceneSpec read(const std::string& body) const {
        return parse_scene(
            "format = \"keiko-scene/1\"\n" + body + "[[model]]\nfile = \"body.step\"\n",
            (folder_.path() / "scene.toml").string());
    }
    std::string refused(const std::string& body) const {
        try {
            read(body);
        } catch (const Error& error) {
            const std::string text = error.what();
            return text.substr(text.find("scene.toml"));
        }
        return {};
    }

private:
    test::TemporaryFolder folder_;
};

TEST(EnvironmentTable, ReadsEveryKey) {
    const SceneSpec scene = Scenes().read(
        "[environment]\nfile = \"studio.exr\"\nlayout = \"cube\"\nluminance = [1, 2, 3]\n"
        "azimuth = -90\nvisible = false\nlights = false\n");
    ASSERT_TRUE(scene.environment);
    EXPECT_EQ(scene.environment->file.filename(), "studio.exr");
    EXPECT_EQ(scene.environment->layout, EnvironmentSpec::Layout::cube);
    EXPECT_EQ(scene.environment->luminance, Rgb(1, 2, 3));
    EXPECT_EQ(scene.environment->azimuth, -90);
    EXPECT_FALSE(scene.environment->visible);
    EXPECT_FALSE(scene.environment->lights);
}

TEST(EnvironmentTable, ASceneInSurroundingsNeedsNoLamps) {
    const SceneSpec scene = Scenes().read("[environment]\nfile = \"studio.exr\"\n");
    ASSERT_TRUE(scene.rig);
    EXPECT_TRUE(scene.rig->sources.empty());
    EXPECT_FALSE(Scenes().read("").rig);
}

TEST(EnvironmentTable, RefusesWhatCannotBe) {
    const Scenes scenes;
    const std::string table = "[environment]\nfile = \"studio.exr\"\n";
    EXPECT_EQ(scenes.refused("[environment]\n"), "scene.toml:2:1: environment: 'file' is missing");
    EXPECT_EQ(scenes.refused(table + "layout = \"cub\"\n"),
              "scene.toml:4:10: environment.layout: 'cub' is none of lat-long, cube (did you mean "
              "'cube'?)");
    EXPECT_EQ(
        scenes.refused(table + "azimuth = 400\n"),
        "scene.toml:4:11: environment.azimuth: must be at least -360 and at most 360, is 400");
    EXPECT_EQ(scenes.refused(table + "gamma = 2\n"),
              "scene.toml:4:1: unknown key 'environment.gamma'");
    EXPECT_EQ(scenes.refused(table + "[sky]\nluminance = 100\n"),
              "scene.toml:2:1: environment: hides the sky: give either [environment] or [sky]");
}

} // namespace
} // namespace keiko
