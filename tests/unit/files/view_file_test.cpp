#include "keiko/base/error.h"
#include "keiko/files/scene/scene_file.h"

#include "tests/support/temporary_folder.h"
#include <gtest/gtest.h>

namespace keiko {
namespace {

TEST(ViewFile, IsToldByItsEnding) {
    EXPECT_TRUE(is_view_file("eyes/driver.toml"));
    EXPECT_FALSE(is_view_file("front"));
}

TEST(ViewFile, HoldsACameraWithoutASize) {
    const test::TemporaryFolder folder;
    const auto path = folder.file("driver.toml", R"(format = "keiko-view/1"
eye = [-2500, -1800, 1650]
target = [600, 0, 750]
vertical_fov = 18
)");
    const Camera camera = read_view(path);
    EXPECT_EQ(camera.eye, Vec3(-2500, -1800, 1650));
    EXPECT_EQ(camera.target, Vec3(600, 0, 750));
    EXPECT_EQ(camera.up, Vec3(0, 0, 1));
    EXPECT_EQ(camera.vertical_fov, 18);
    EXPECT_EQ(camera.width, Camera().width);
}

TEST(ViewFile, ErrorsNameLineAndReason) {
    const test::TemporaryFolder folder;
    const auto reason = [&](const std::string& text) {
        try {
            read_view(folder.file("v.toml", "format = \"keiko-view/1\"\n" + text));
        } catch (const Error& error) {
            return std::string(error.what());
        }
        return std::string("none");
    };
    EXPECT_NE(reason("eye = [0, 0, 1]\n").find("target"), std::string::npos);
    EXPECT_NE(reason("eye = [0, 0, 1]\ntarget = [0, 0, 1]\n").find("must differ from eye"),
              std::string::npos);
    EXPECT_NE(
        reason("eye = [0, 0, 1]\ntarget = [0, 0, 0]\nup = [0, 1, 0]\nsize = [3, 4]\n").find("size"),
        std::string::npos);
}

} // namespace
} // namespace keiko
