// The rigs that come with Keiko.
#include "keiko/base/input_file.h"
#include "keiko/files/scene/rig_file.h"

#include "tests/support/paths.h"
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

namespace keiko {
namespace {

namespace fs = std::filesystem;

TEST(ReadyRigs, EveryRigOfTheFolderLoadsAndStandsInItsTable) {
    const std::string table = read_file(test::repository("lightrigs/README.md"));
    int rigs = 0;
    for (const auto& entry : fs::directory_iterator(test::repository("lightrigs"))) {
        const fs::path& path = entry.path();
        if (path.extension() != ".toml") continue;
        const std::string name = path.filename().string();
        EXPECT_NE(table.find("[" + name + "](" + name + ")"), std::string::npos) << name;
        if (name == "materials.toml") continue;
        ++rigs;
        const LightRig rig = read_rig(path);
        EXPECT_EQ(rig.name, path.stem().string());
        EXPECT_FALSE(rig.sources.empty()) << name;
        EXPECT_EQ(rig_text(parse_rig(rig_text(rig), name)), rig_text(rig)) << name;
    }
    EXPECT_GE(rigs, 4);
}

/// A car's middle lies before every panel.
TEST(ReadyRigs, PanelsOfTheReadyRigsShineOnTheBody) {
    std::size_t panels = 0;
    for (const std::string name :
         {"panel-tunnel", "zebra-screen", "cylinder-tunnel", "meridian-dome"})
        for (const LightSource& source :
             read_rig(test::repository("lightrigs/" + name + ".toml")).sources) {
            EXPECT_TRUE(std::get<PolygonLight>(source).shines_at(Vec3(0, 0, 700))) << name;
            ++panels;
        }
    EXPECT_EQ(panels, 7U + 20 + 12 + 72);
}

} // namespace
} // namespace keiko
